"""Reads and checks the results.json of `evaluate --report`."""
import json
import os

from report_tools.results import KINDS, Curve, Results, Scene, Score

_FORMAT = 1
_LARGEST = 1e300


class ReportError(Exception):
    """A sentence for the user."""


def _describe(value):
    text = json.dumps(value)
    return text if len(text) <= 40 else text[:37] + "..."


def _fail(where, expected, value):
    raise ReportError("%s: expected %s, found %s" % (where, expected, _describe(value)))


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _finite(value):
    """None for NaN, infinities and whole numbers beyond the range of a float."""
    return value if value is not None and abs(value) < _LARGEST else None


def _member(parent, key, where):
    if not isinstance(parent, dict):
        _fail(where, "a map", parent)
    if key not in parent:
        raise ReportError("%s: has no \"%s\"" % (where, key))
    return parent[key], "%s.%s" % (where, key)


def _number(parent, key, where):
    value, where = _member(parent, key, where)
    if value is not None and not _is_number(value):
        _fail(where, "a number or null", value)
    return _finite(value)


def _count(parent, key, where):
    value = _number(parent, key, where)
    if value is None or value < 0 or value != int(value):
        _fail("%s.%s" % (where, key), "a whole number from 0 on", value)
    return int(value)


def _text(parent, key, where):
    value, where = _member(parent, key, where)
    if not isinstance(value, str) or not value:
        _fail(where, "a name", value)
    return value


def _list(parent, key, where):
    value, where = _member(parent, key, where)
    if not isinstance(value, list):
        _fail(where, "a list", value)
    return value


def _numbers(parent, key, where, count):
    """A list of `count` numbers or nulls; null alone stands for as many nulls."""
    value, where = _member(parent, key, where)
    if value is None:
        return (None,) * count
    if not (isinstance(value, list) and len(value) == count
            and all(number is None or _is_number(number) for number in value)):
        _fail(where, "a list of %d numbers" % count, value)
    return tuple(_finite(number) for number in value)


def _check_unique(names, where):
    for name in names:
        if names.count(name) > 1:
            raise ReportError("%s: %s occurs twice" % (where, _describe(name)))


def _read_curve(result, where):
    curve, where = _member(result, "curve", where)
    if curve is None:
        return Curve((), (), ())
    completeness = _list(curve, "completeness", where)
    count = len(completeness)
    return Curve(*(_numbers(curve, key, where, count) for key in Curve._fields))


def _read_score(result, thresholds, where):
    scalars = {key: _number(result, key, where) for key in (
        "invalid", "average_error", "area_u", "area_confidence", "area_oracle", "seconds")}
    errors = {key: _numbers(result, key, where, len(thresholds))
              for key in ("bad_" + kind for kind in KINDS)}
    return Score(curve=_read_curve(result, where), **scalars, **errors)


def _read_scenes(root, where):
    scenes = []
    for index, scene in enumerate(_list(root, "scenes", where)):
        at = "%s.scenes[%d]" % (where, index)
        scenes.append(Scene(_text(scene, "name", at), _count(scene, "width", at),
                            _count(scene, "height", at), _count(scene, "disparities", at)))
    _check_unique([scene.name for scene in scenes], where + ".scenes")
    return tuple(scenes)


def _read_variants(root, where):
    variants = _list(root, "variants", where)
    if not all(isinstance(variant, str) and variant for variant in variants):
        _fail(where + ".variants", "a list of names", variants)
    _check_unique(variants, where + ".variants")
    return tuple(variants)


def _read_thresholds(root, where):
    thresholds = _list(root, "thresholds", where)
    if not thresholds or not all(_is_number(t) and 0 < t < _LARGEST for t in thresholds):
        _fail(where + ".thresholds", "numbers above 0", thresholds)
    _check_unique(thresholds, where + ".thresholds")
    report_threshold = _number(root, "report_threshold", where)
    if report_threshold not in thresholds:
        _fail(where + ".report_threshold", "one of the thresholds", report_threshold)
    return tuple(thresholds), report_threshold


def _read_scores(root, thresholds, scenes, variants, where):
    scores = {}
    for index, result in enumerate(_list(root, "results", where)):
        at = "%s.results[%d]" % (where, index)
        key = _text(result, "scene", at), _text(result, "variant", at)
        if key[0] not in [scene.name for scene in scenes]:
            _fail(at + ".scene", "one of the scenes", key[0])
        if key[1] not in variants:
            _fail(at + ".variant", "one of the variants", key[1])
        if key in scores:
            raise ReportError("%s: %s on %s occurs twice" % (at, key[1], key[0]))
        scores[key] = _read_score(result, thresholds, at)
    if not scores:
        raise ReportError("%s: holds no results" % where)
    return scores


def _load(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except FileNotFoundError:
        raise ReportError("%s: there is no such file; make it by evaluate SCENES --report %s" %
                          (path, os.path.dirname(path) or ".")) from None
    except OSError as error:
        raise ReportError("%s: %s" % (path, error.strerror)) from None
    # Not UTF-8, not JSON, or nested without end.
    except (ValueError, RecursionError) as error:
        raise ReportError("%s: not a JSON file (%s)" % (path, error)) from None


def read_results(folder):
    """Reads and checks `folder`/results.json; ReportError names what is wrong with it."""
    path = os.path.join(folder, "results.json")
    root = _load(path)
    version = _member(root, "format", path)[0]
    if version != _FORMAT:
        _fail(path + ".format", str(_FORMAT), version)
    options, where = _member(root, "options", path)
    if not isinstance(options, dict):
        _fail(where, "a map", options)
    machine, where = _member(root, "machine", path)
    threads = _number(machine, "threads", where)
    thresholds, report_threshold = _read_thresholds(root, path)
    scenes = _read_scenes(root, path)
    variants = _read_variants(root, path)
    scores = _read_scores(root, thresholds, scenes, variants, path)
    min_error_share = _number(root, "min_error_share", path)
    return Results(folder, thresholds, report_threshold, min_error_share, options, threads, scenes,
                   variants, scores)
