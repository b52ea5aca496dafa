# SPDX-License-Identifier: Apache-2.0
"""Animations through the command line. run_frames.py CDSM SCENE

Images of a range of frames are byte for byte those of each frame alone and of the still scene with the frame's values;
statistics and trace hold each frame; an error in the middle leaves the images before it."""
import json
import pathlib
import sys
import tempfile

import job

TIMEOUT_SECONDS = 120
FIRST, LAST = 3, 5
STILL = {"camera.fov": "46", "light.key.position": "[0.5, 4.0, 0.25]", "volume.slab.opacity": "[[0.0, 0.625]]"}
TABLES = "[[animate]]"


def still_text(scene):
    """The scene without its animation, from any folder."""
    return scene.read_text().split(TABLES)[0].replace("filled.nrrd", str(scene.parent / "filled.nrrd"))


def render(cdsm, scene, *arguments):
    """Exit status and what was said."""
    small = ["--set", "image.width=90", "--set", "image.height=60"]
    return job.run([cdsm, "render", scene, "--quiet"] + small + [str(part) for part in arguments], TIMEOUT_SECONDS)


def rendered(cdsm, scene, image, *arguments):
    """The bytes of one image."""
    status, output = render(cdsm, scene, "-o", image, *arguments)
    if status != 0 or not image.exists():
        job.fail(f"{arguments}: exit status {status}: {output}")
    return image.read_bytes()


def check_trace(events):
    """One trace of all frames: each with its steps, and the device's commands within them."""
    spans = {event["name"]: (event["ts"], event["ts"] + event["dur"]) for event in events if event["ph"] == "X"
             and event["name"].startswith("frame ")}
    if sorted(spans) != [f"frame {number}" for number in range(FIRST, LAST + 1)]:
        job.fail(f"the trace holds {sorted(spans)}")
    for event in events:
        if event["ph"] == "X" and (event["tid"] == 2 or event["name"] in ("render image", "write image")):
            inside = [name for name, (begin, end) in spans.items()
                      if begin <= event["ts"] and event["ts"] + event["dur"] <= end]
            if len(inside) != 1:
                job.fail(f"in the trace, {event} lies in {len(inside)} frames")


def check_range(cdsm, scene, folder):
    """The images of the frames in one run, by frame."""
    stats, trace = folder / "stats.json", folder / "trace.json"
    status, output = render(cdsm, scene, "--frames", f"{FIRST}:{LAST}", "-o", folder / "f_%02d.png", "--stats", stats,
                            "--trace", trace)
    names = sorted(path.name for path in folder.iterdir())
    if status != 0 or names != ["f_03.png", "f_04.png", "f_05.png", "stats.json", "trace.json"]:
        job.fail(f"exit status {status}, files {names}: {output}")
    numbers = [frame["frame"] for frame in json.loads(stats.read_text())["frames"]]
    if numbers != list(range(FIRST, LAST + 1)):
        job.fail(f"statistics hold the frames {numbers}")
    check_trace(json.loads(trace.read_text())["traceEvents"])
    return {frame: (folder / f"f_{frame:02d}.png").read_bytes() for frame in numbers}


def check_frames(cdsm, scene, folder, images):
    for frame, image in images.items():
        if rendered(cdsm, scene, folder / "alone.png", "--frames", frame) != image:
            job.fail(f"frame {frame} alone differs from the same of the range")
    if len(set(images.values())) != len(images):
        job.fail("frames do not differ from each other")
    settings = [part for key, value in STILL.items() for part in ("--set", f"{key}={value}")]
    still = folder / "still.toml"
    still.write_text(still_text(scene))
    if rendered(cdsm, still, folder / "still.png", *settings) != images[LAST]:
        job.fail(f"frame {LAST} differs from the still scene with its values")
    if rendered(cdsm, scene, folder / "first.png") != rendered(cdsm, scene, folder / "0.png", "--frames", 0):
        job.fail("without --frames it is not frame 0")


def check_error(cdsm, scene, folder):
    """The angle of view gets too wide at the last of three frames."""
    wide = folder / "wide.toml"
    wide.write_text(still_text(scene) + TABLES + "\nkey = 'camera.fov'\nframes = [[0, 160], [2, 180]]\n")
    status, output = render(cdsm, wide, "--frames", "0:4", "-o", folder / "w%d.png", "--stats", folder / "s.json")
    left = sorted(path.name for path in folder.iterdir() if path != wide)
    if status != 1 or "frame 2: fov is 180, must be in (0, 180)" not in output or left != ["w0.png", "w1.png"]:
        job.fail(f"exit status {status}, files {left}: {output}")


def main():
    cdsm, scene = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as frames, tempfile.TemporaryDirectory() as stills:
        check_frames(cdsm, scene, pathlib.Path(stills), check_range(cdsm, scene, pathlib.Path(frames)))
    with tempfile.TemporaryDirectory() as folder:
        check_error(cdsm, scene, pathlib.Path(folder))
    print("frames are the same however they are rendered")


main()
