"""A motion as a file that plays: an HTML page, a GIF or an MP4."""

from __future__ import annotations

import importlib
import math
import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from freebody.errors import InputError
from freebody.language.plain_text import plain, shortened
from freebody.present.drawing import Drawing
from freebody.present.figures import Array
from freebody.present.files import replaced
from freebody.present.marks import ContactTrack
from freebody.present.plane_page import note_on, page
from freebody.present.scene import Scene
from freebody.present.stills import frame_axes, paint
from freebody.present.theme import THEMES

RATE = 30  # frames a second of shown time
GIF_RATE = 25  # GIF counts hundredths of a second
N_FRAMES = 3000
FEWEST = 120  # of a page, which can be slowed down
_PIXELS, _DPI = 640, 100
MOST_IN_TITLE = 200  # characters over a film


def write_animation(
    scene: Scene,
    times: Array,
    poses: Array,
    path: str | Path,
    *,
    title: str,
    speed: float = 1.0,
    contacts: ContactTrack | None = None,
) -> Path:
    """Writes a motion as `.html` (one page with controls, no network), `.gif` or `.mp4`, by the suffix of the path.

    times: (n_times,) [s], ascending, a repeated time counts once (its last pose). poses: (n_times, n_moving_bodies,
    3), x and y of the mass centre [m] and the angle [rad], continuous, in the order of `scene.names`. speed: seconds
    of motion in a second of showing. contacts: where bodies touch at the given times, to be marked. Returns the path.
    Raises InputError if these do not fit together, the suffix is another one, the file cannot be written, or there is
    no ffmpeg for an MP4."""
    return write_film(_Film(scene, _checked(scene, times, poses, contacts), title, speed), path)


class Film(Protocol):
    """A motion that can be shown; speed: seconds of motion in a second of showing."""

    @property
    def speed(self) -> float: ...

    def page(self) -> str:
        """The text of a page that plays it."""
        ...

    def stages(self, rate: int) -> tuple[Any, Iterator[None]]:
        """A figure, and an iterator that brings it to one frame after the other, at a rate [1/s]."""
        ...


def write_film(film: Film, path: str | Path) -> Path:
    """Writes a film as `.html`, `.gif` or `.mp4`, by the suffix of the path, which it returns. Raises InputError for
    another one, a speed that is not positive, a file that cannot be written, or an MP4 without ffmpeg."""
    path = Path(path)
    if not (math.isfinite(film.speed) and film.speed > 0):
        raise InputError(f"the speed of an animation is a positive number, not {film.speed}")
    writers: dict[str, Callable[[Path], None]] = {
        ".html": lambda file: _written(file, film.page()),
        ".gif": lambda file: _write_gif(*film.stages(GIF_RATE), file),
        ".mp4": lambda file: _write_mp4(film, file),
    }
    suffix = path.suffix.lower()
    if suffix not in writers:
        raise InputError(f"{path.name}: an animation is written as {', '.join(writers)}; give one of these suffixes")
    with replaced(path) as file:
        writers[suffix](file)
    return path


def resampled(times: Array, poses: Array, n_frames: int) -> tuple[Array, Array]:
    """(n_frames,), (n_frames, n_bodies, 3): the motion at equally spaced times, by a cubic between the given poses
    that does not overshoot them. Source: Fritsch & Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300."""
    from scipy.interpolate import PchipInterpolator

    if len(times) == 1:
        return times, poses
    shown: Array = np.linspace(float(times[0]), float(times[-1]), n_frames)
    cubic: Any = PchipInterpolator(times, poses, axis=0)
    return shown, np.asarray(cubic(shown), dtype=np.float64)


@dataclass(frozen=True)
class _Motion:
    """Poses and contacts at times that ascend."""

    times: Array
    poses: Array
    contacts: ContactTrack | None

    def drawn(self, scene: Scene, n_frames: int) -> tuple[Drawing, Array]:
        """The drawing of frames at equally spaced times, and these times."""
        shown, frames = resampled(self.times, self.poses, n_frames)
        track = None if self.contacts is None else self.contacts.at(self.times, shown)
        return Drawing.of(scene, frames, track), shown


def _checked(scene: Scene, times: Array, poses: Array, contacts: ContactTrack | None) -> _Motion:
    times, poses = np.asarray(times, dtype=np.float64), np.asarray(poses, dtype=np.float64)
    shape = (len(times), len(scene.names), 3) if times.ndim == 1 else None
    if shape is None or not len(times) or poses.shape != shape:
        raise InputError(
            f"an animation of {len(scene.names)} moving bodies needs times (n_times,) and poses "
            f"(n_times, {len(scene.names)}, 3), not {times.shape} and {poses.shape}"
        )
    if not (np.isfinite(times).all() and np.isfinite(poses).all()):
        raise InputError("the times and poses of an animation must be finite numbers")
    if (np.diff(times) < 0).any():
        raise InputError("the times of an animation must ascend")
    if contacts is not None and len(contacts.states) != len(times):
        raise InputError(f"an animation needs contacts for its {len(times)} times, not for {len(contacts.states)}")
    last = np.append(np.diff(times) > 0, True)
    kept = None if contacts is None else ContactTrack(contacts.meetings, contacts.states[last])
    return _Motion(times[last], poses[last], kept)


def n_frames(times: Array, speed: float, rate: int) -> int:
    """Of a film at a rate [1/s]."""
    return min(N_FRAMES, math.ceil((times[-1] - times[0]) / speed * rate - 1e-9) + 1)


@dataclass(frozen=True)
class _Film:
    """A motion of the plane, and how it is to be shown."""

    scene: Scene
    motion: _Motion
    title: str
    speed: float

    def page(self) -> str:
        drawing, shown = self.motion.drawn(self.scene, max(FEWEST + 1, n_frames(self.motion.times, self.speed, RATE)))
        return page(drawing, shown, self.title, self.speed)

    def stages(self, rate: int) -> tuple[Any, Iterator[None]]:
        drawing, shown = self.motion.drawn(self.scene, n_frames(self.motion.times, self.speed, rate))
        return _stages(drawing, shown, self.title)


def _written(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8")


def _write_gif(figure: Any, stages: Iterator[None], path: Path) -> None:
    """A GIF of a figure that an iterator brings to one frame after the other."""
    from PIL import Image

    pictures = [Image.fromarray(rgb) for rgb in _pictures(figure, stages)]
    # one palette for all, so that colours do not flicker
    palette = pictures[len(pictures) // 2].quantize(64, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    small = [p.quantize(palette=palette, dither=Image.Dither.NONE) for p in pictures]
    small[0].save(path, save_all=True, append_images=small[1:], duration=1000 // GIF_RATE, loop=0, optimize=False)


def _write_mp4(film: Film, path: Path) -> None:
    """Raises InputError without ffmpeg."""
    program = _ffmpeg()  # first, because drawing takes long
    figure, stages = film.stages(RATE)
    matplotlib: Any = importlib.import_module("matplotlib")
    animation: Any = importlib.import_module("matplotlib.animation")
    with matplotlib.rc_context({"animation.ffmpeg_path": program}):
        writer = animation.FFMpegWriter(fps=RATE, codec="h264", extra_args=["-pix_fmt", "yuv420p"])
        with writer.saving(figure, str(path), _DPI):
            for _ in stages:
                writer.grab_frame()


def _ffmpeg() -> str:
    """The program that codes videos: that of imageio-ffmpeg, or one on the PATH."""
    try:
        program: str = importlib.import_module("imageio_ffmpeg").get_ffmpeg_exe()
    except (ImportError, RuntimeError):
        program = shutil.which("ffmpeg") or ""
    if not program:
        raise InputError(
            'an MP4 needs ffmpeg, and there is none: pip install "freebody[video]", or write .html or .gif instead'
        )
    return program


# -- frames with Matplotlib -------------------------------------------------------------------
def _stages(drawing: Drawing, times: Array, title: str) -> tuple[Any, Iterator[None]]:
    """A figure, and an iterator that brings it to one frame after the other."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    width, height = drawing.high - drawing.low
    shape = min(1.6, max(0.5, height / width))
    even = 2 * round(_PIXELS * min(1.3, shape) / 2)  # video codecs want even numbers of pixels
    figure: Any = Figure(figsize=(_PIXELS / _DPI, (even + 80) / _DPI), dpi=_DPI, layout="constrained")
    FigureCanvasAgg(figure)
    theme = THEMES["light"]
    figure.set_facecolor(theme.paper)
    axes = figure.add_subplot()
    frame_axes(drawing, axes, theme)
    figure.suptitle(shortened(plain(title), MOST_IN_TITLE), fontsize=11, color=theme.ink, parse_math=False, wrap=True)
    note = note_on(drawing)
    if note:
        figure.supxlabel(note, fontsize=7, color=theme.muted, parse_math=False, wrap=True)
    clock = axes.set_title("", fontsize=9, color=theme.muted, loc="left")

    def stages() -> Iterator[None]:
        for frame, t in enumerate(times):
            artists = paint(drawing, frame, axes, theme)
            clock.set_text(f"t = {t:.2f} s")
            if frame == 0:
                figure.draw_without_rendering()
                figure.set_layout_engine("none")
            yield
            for artist in artists:
                artist.remove()

    return figure, stages()


def _pictures(figure: Any, stages: Iterator[None]) -> Iterator[Any]:
    """(height, width, 3) bytes of each frame."""
    for _ in stages:
        figure.canvas.draw()
        yield np.asarray(figure.canvas.buffer_rgba())[:, :, :3].copy()
