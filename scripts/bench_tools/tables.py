"""The measurements as Markdown."""


def _number(value, digits):
    return "-" if value is None else "%.*f" % (digits, value)


def _table(head, rows):
    lines = ["| %s |" % " | ".join(head), "|---|" + "---:|" * (len(head) - 1)]
    return "\n".join(lines + ["| %s |" % " | ".join(row) for row in rows])


def checks_table(checks):
    head = ("case", "size", "ms", "reference, ms", "ratio", "bar", "")
    return _table(head, [
        (check.bar.case, str(check.bar.size), _number(check.ours_ms, 1),
         _number(check.reference_ms, 1), _number(check.ratio, 3),
         ("≥ %g" if check.bar.at_least else "≤ %g") % check.bar.bound, check.verdict)
        for check in checks])


def size_table(rows):
    head = ("subject", "threads", "ms", "fastest to slowest", "of 3WAY", "MDE/s", "first, ms",
            "peak, MB")
    return _table(head, [
        (row.subject, str(row.threads), _number(row.ms, 1),
         "%.1f to %.1f" % (row.fastest_ms, row.slowest_ms), _number(row.of_reference, 3),
         _number(row.mde_per_second, 0), _number(row.first_ms, 0),
         _number(None if row.peak_bytes is None else row.peak_bytes * 1e-6, 0))
        for row in sorted(rows.values(), key=lambda row: (-row.threads, row.subject))])


# In the order of a frame; any others come after them.
_STAGES = ("images", "alignment", "coarse pass", "prior", "cost", "aggregation", "refinement")


def stages_table(rows):
    """The stages within frames."""
    frames = [row for row in rows.values() if row.stages]
    present = set().union(*(row.stages for row in frames))
    names = [name for name in _STAGES if name in present]
    names += sorted(present.difference(names))
    return _table(("frame, ms of its stages", "threads", *names), [
        (row.subject, str(row.threads), *(_number(row.stages.get(name), 1) for name in names))
        for row in frames])


def ceilings_table(ceilings):
    """What the machine can do, by the number of threads."""
    names = list(dict.fromkeys(name.rsplit("/", 1)[0] for name in ceilings))
    return _table(("10^9 per second", "1 thread", "2 threads"), [
        (name.split("/", 1)[1].replace("_", " "),
         *(_number(ceilings.get("%s/%d" % (name, threads)), 1) for threads in (1, 2)))
        for name in names])


def roofline_table(lines):
    head = ("stage", "operations", "bytes", "ms", "ms by operations", "ms by memory", "share")
    return _table(head, [
        (line.stage, _number(line.work.operations / line.per, 1),
         _number(line.work.bytes / line.per, 2), _number(line.ms, 1),
         _number(line.operations_ms, 1), _number(line.memory_ms, 1), "%.0f %%" % (100 * line.share))
        for line in lines])


def roofline_section(ceilings, lines_by_size):
    parts = ["## Roofline",
             "Ceilings: bytes moved, or minima and additions of bytes, per second.",
             ceilings_table(ceilings),
             "Operations (of single bytes) and bytes of memory for each pixel and disparity, as "
             "the method needs them at least; the times that they would take at the ceilings with "
             "two threads; the share of the nearer ceiling that is reached."]
    for size, lines in lines_by_size.items():
        if not lines:
            continue
        parts += ["### %s" % str(size), roofline_table(lines)]
    return "\n\n".join(parts)


def page(machine, checks, rows_by_size, roofline):
    parts = ["# Benchmark", "; ".join("%s: %s" % item for item in machine.items()),
             "Medians of runs in turns, milliseconds. MDE/s: millions of width x height x "
             "disparities per second. OpenCV computes only the columns that all disparities reach.",
             "## Bars", checks_table(checks)]
    for size, rows in rows_by_size.items():
        parts += ["## " + str(size), size_table(rows), stages_table(rows)]
    return "\n\n".join(parts + [roofline]) + "\n"
