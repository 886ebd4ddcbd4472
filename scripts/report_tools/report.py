"""The report: which figures and tables it has, in which order, and what is said about them."""
from report_tools import tables
from report_tools.bars import draw_gains, draw_seconds
from report_tools.curves import BY_CONFIDENCE, BY_U, draw_curves
from report_tools.figures import FOLDER
from report_tools.gains import WORSE, sorting_variant
from report_tools.page import Bullets, Code, FigureLink, Heading, Paragraph, Pictures
from report_tools.results import BASELINE
from report_tools.style import variant_styles


def report_blocks(results, command):
    """Draws the figures and returns the page; `command` is the one that repeats it, or None."""
    return [*_head(results, command), *_summary(results), *_curves(results), *_gains(results),
            *_errors(results), *_seconds(results), *_maps(results), *_options(results)]


def _label(results, variant):
    return variant_styles(results.variants)[variant].label


def _figure(name, caption):
    return FigureLink("%s/%s" % (FOLDER, name), caption)


def _head(results, command):
    labels = [_label(results, variant) for variant in results.variants]
    items = ["Scenes: %d" % len(results.scenes),
             "Variants: " + ", ".join(labels),
             "Thresholds: %s px; curves and gains at %g px" %
             (", ".join("%g" % threshold for threshold in results.thresholds),
              results.report_threshold),
             "Threads: " + tables.number(results.threads, 0)]
    if results.min_error_share:
        items.append("Errors up to %g %% of the true disparity do not count" %
                     (100.0 * results.min_error_share))
    blocks = [Heading(1, "Evaluation of stereo matching with orientation priors"),
              Bullets(tuple(items)),
              Paragraph("Errors are percentages of the evaluated pixels: \"bad T\" are those wrong "
                        "by more than T pixels of the ground truth. The raw map is unfiltered; "
                        "where it has no disparity, as that of OpenCV, it is wrong. The dense map "
                        "has its holes filled, and of the published map the valid pixels are "
                        "counted. Means are over the scenes that all variants have; "
                        "\"-\" stands for what was not measured.")]
    if command:
        blocks += [Paragraph("To run it again:"), Code(command)]
    return blocks + [Paragraph("To draw the figures and this page anew from results.json:"),
                     Code("scripts/report FOLDER_OF_THIS_PAGE")]


def _summary(results):
    return [Heading(2, "Means"), tables.summary(results),
            Paragraph("The areas are those under the curve of error against completeness (bad %g, "
                      "raw), with the pixels in the order of U, of the published confidence, and "
                      "in the best order there is." % results.report_threshold)]


def _curves(results):
    blocks = [Heading(2, "Error against completeness")]
    for order in (BY_U, BY_CONFIDENCE):
        if draw_curves(results, order):
            blocks += [Paragraph("Errors of the most certain pixels by the %s. Lines far above "
                                 "those of SGM and its priors leave the plots." % order.caption),
                       _figure(order.name, "Error against completeness by the " + order.caption)]
        else:
            blocks.append(Paragraph("There are no curves by the %s." % order.caption))
    return blocks


def _gains(results):
    read = results.bad("raw", results.report_threshold)
    name = "gains"
    blocks = [Heading(2, "Gains over SGM")]
    if not draw_gains(results, read, name):
        return blocks + [Paragraph("They need results of SGM (%s) and of another variant on the "
                                   "same scene." % BASELINE)]
    by = _label(results, sorting_variant(results, read))
    return blocks + [
        Paragraph("How many percent fewer errors a variant has than SGM (raw bad %g), scenes in "
                  "the order of the gain of %s. Dashed lines are the means of the gains. A bar "
                  "that would go too far down is cut and says its value." %
                  (results.report_threshold, by)),
        _figure(name, "Gains over SGM per scene"),
        tables.gains(results, read),
        Paragraph("For each map and threshold: mean of the gains / gain of the means / number of "
                  "scenes with more than %g %% more errors." % WORSE),
        tables.gain_summary(results)]


def _errors(results):
    blocks = [Heading(2, "Errors per scene")]
    for kind in ("raw", "dense"):
        for threshold in results.thresholds:
            blocks += [Heading(3, "Bad %g, %s map, percent" % (threshold, kind)),
                       tables.per_scene(results, results.bad(kind, threshold))]
    return blocks


def _seconds(results):
    name = "seconds"
    blocks = [Heading(2, "Run times")]
    if not draw_seconds(results, name):
        blocks.append(Paragraph("There is no scene on which the times of all variants are known."))
    else:
        blocks.append(_figure(name, "Run times and overhead over SGM"))
    return blocks + [Paragraph("Seconds:"), tables.seconds(results)]


def _scene_pictures(results, scene):
    """Disparities above error maps; in the first column the left image above the truth."""
    columns = [("left image, truth", (results.map_path(scene + "_left"),
                                      results.map_path(scene + "_truth")))]
    for variant in results.variants:
        columns.append((_label(results, variant),
                        (results.map_path("%s_%s_disparity" % (scene, variant)),
                         results.map_path("%s_%s_error" % (scene, variant)))))
    return Pictures(tuple(column for column in columns if any(column[1])))


def _maps(results):
    blocks = [Heading(2, "Error maps")]
    of_scenes = {scene.name: _scene_pictures(results, scene.name) for scene in results.scenes}
    if not any(pictures.columns for pictures in of_scenes.values()):
        return blocks + [Paragraph("There are no pictures in maps/.")]
    blocks.append(Paragraph(
        "Raw disparities above the maps of their errors above %g px: light gray is right, yellow "
        "to dark red is wrong by more and more, blue has no disparity, and what is nearly black is "
        "not evaluated." % results.report_threshold))
    for name, pictures in of_scenes.items():
        if pictures.columns:
            blocks += [Heading(3, name), pictures]
    return blocks


def _options(results):
    return [Heading(2, "Options"), tables.options_table(results)] if results.options else []
