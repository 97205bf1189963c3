# SPDX-License-Identifier: LGPL-2.1-or-later
"""Films of pictures: mp4 by ffmpeg, gif by ffmpeg or Pillow."""

import os
import shutil
import subprocess
import tempfile

from .errors import InputError

ENDINGS = (".mp4", ".gif")


def require_maker(path):
    """Which tool makes this film; says what is missing before any picture is drawn."""
    ending = os.path.splitext(path)[1].lower()
    if ending not in ENDINGS:
        raise InputError(f"--film {path}: the ending must be {' or '.join(ENDINGS)}")
    if shutil.which("ffmpeg"):
        return "ffmpeg"
    if ending == ".mp4":
        raise InputError(
            "mp4 needs ffmpeg, which is not there: apt install ffmpeg, or use --film with a name"
            " that ends in .gif, or --frame all for pictures"
        )
    try:
        import PIL  # noqa: F401
    except ImportError as error:
        raise InputError(
            "gif needs ffmpeg or Pillow: apt install ffmpeg or apt install python3-pil"
        ) from error
    return "pillow"


def best_ending():
    """'.mp4' where ffmpeg can make it, else '.gif'."""
    ending = ".mp4" if shutil.which("ffmpeg") else ".gif"
    require_maker("film" + ending)
    return ending


def make(path, frames_per_second, draw, n_frames):
    """
    Makes a film of @n_frames pictures that draw(number, path) writes as png files of one size; the
    file is written whole or not at all.
    """
    maker = require_maker(path)
    folder, name = os.path.split(path)
    if folder:
        os.makedirs(folder, exist_ok=True)
    temporary = os.path.join(folder, ".part-" + name)
    with tempfile.TemporaryDirectory(prefix="softgrain-film-") as pictures:
        files = [os.path.join(pictures, f"{number:06d}.png") for number in range(n_frames)]
        for number, file in enumerate(files):
            draw(number, file)
        try:
            (by_ffmpeg if maker == "ffmpeg" else by_pillow)(files, temporary, frames_per_second)
            os.replace(temporary, path)
        finally:
            if os.path.exists(temporary):
                os.remove(temporary)


def by_ffmpeg(files, path, frames_per_second):
    """libx264 wants an even number of pixels; gif gets a palette of its own."""
    command = [
        "ffmpeg",
        "-y",
        "-loglevel",
        "error",
        "-framerate",
        f"{frames_per_second:g}",
        "-i",
        os.path.join(os.path.dirname(files[0]), "%06d.png"),
    ]
    if path.lower().endswith(".gif"):
        command += [
            "-filter_complex",
            "split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=none",
        ]
    else:
        command += [
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white",
            "-c:v",
            "libx264",
            "-crf",
            "18",
            "-pix_fmt",
            "yuv420p",
            "-movflags",
            "+faststart",
        ]
    done = subprocess.run([*command, path], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or [f"it ended with status {done.returncode}"]
        raise InputError(f"ffmpeg cannot make the film: {lines[-1]}")


def by_pillow(files, path, frames_per_second):
    """All frames by the colours of one palette, so that they do not flicker."""
    from PIL import Image

    images = [Image.open(file).convert("RGB") for file in files]
    palette = images[-1].quantize(255)
    frames = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    frames[0].save(
        path,
        format="GIF",
        save_all=True,
        append_images=frames[1:],
        loop=0,
        duration=max(20, round(1000 / frames_per_second)),
        optimize=False,
    )
