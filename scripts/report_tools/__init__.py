"""Figures and report of the folder that `evaluate --report` writes."""
