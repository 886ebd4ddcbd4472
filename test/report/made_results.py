"""A made-up folder like that of `evaluate --report`, for the tests."""
import copy
import json
import os
import random

# Errors of each variant as a share of those of SGM, and seconds.
_QUALITY = {"sgm": (1.0, 0.50), "epi": (0.88, 0.60), "epv": (0.87, 0.65), "gs": (0.45, 0.55),
            "gp": (0.5, 0.6), "gni": (0.95, 0.9), "gnv": (0.55, 1.3), "mw": (0.8, 1.1)}
_OTHER_QUALITY = (1.9, 0.04)

# The smallest PNG there is: one gray pixel.
_PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010800000000"
    "3a7e9b550000000a49444154789c6360000000020001487fa8c80000000049454e44ae426082")


def curve(error):
    """Falls from `error` at all pixels to a quarter of it."""
    shares = [(index + 1) / 100 for index in range(100)]
    errors = [error * (0.25 + 0.75 * share * share) for share in shares]
    return {"completeness": shares, "error_u": errors,
            "error_confidence": [0.9 * value for value in errors]}


def result(scene, variant, error, seconds):
    """`error` is raw bad 2."""
    bad_raw = [3 * error, 1.6 * error, error]
    return {"scene": scene, "variant": variant, "bad_raw": bad_raw,
            "bad_dense": [0.8 * value for value in bad_raw],
            "bad_published": [0.4 * value for value in bad_raw], "invalid": 8.0,
            "average_error": error / 5, "area_u": error / 3, "area_confidence": error / 4,
            "area_oracle": error / 9, "seconds": seconds, "overhead": None, "gain": None,
            "curve": curve(error)}


def document(scenes, variants, results):
    """results.json of scenes of the same size."""
    return {"format": 1, "thresholds": [0.5, 1, 2], "report_threshold": 2.0,
            "min_error_share": 0,
            "options": {"num_disparities": 70, "prior": {"variant": "epv", "min_support": 0.2}},
            "machine": {"threads": 4},
            "scenes": [{"name": name, "width": 640, "height": 480, "disparities": 70}
                       for name in scenes],
            "variants": list(variants), "results": copy.deepcopy(results)}


def plausible(scenes, variants, seed=1):
    """Errors and gains that differ from scene to scene."""
    source = random.Random(seed)
    results = []
    for scene in scenes:
        error = source.uniform(3, 25)
        benefit = source.uniform(-0.1, 2)
        for variant in variants:
            share, seconds = _QUALITY.get(variant, _OTHER_QUALITY)
            gain = (1 - share) * benefit * source.uniform(0.9, 1.1)
            results.append(result(scene, variant, error * max(0.1, 1 - gain), seconds))
    return document(scenes, variants, results)


def write(folder, content, pictures=True):
    """results.json, and a picture for each name that the report may ask for."""
    os.makedirs(os.path.join(folder, "maps"), exist_ok=True)
    with open(os.path.join(folder, "results.json"), "w", encoding="utf-8") as file:
        json.dump(content, file)
    if not pictures:
        return
    for scene in content["scenes"]:
        names = ["left", "truth"]
        for variant in content["variants"]:
            names += [variant + "_disparity", variant + "_error"]
        for name in names:
            path = os.path.join(folder, "maps", "%s_%s.png" % (scene["name"], name))
            with open(path, "wb") as file:
                file.write(_PNG)
