"""A motion as a file that plays: an HTML page, a GIF or an MP4."""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.errors import InputError
from freebody.messages import Message
from freebody.present.drawing import Drawing
from freebody.present.figures import Array
from freebody.present.files import replaced
from freebody.present.marks import ContactTrack
from freebody.present.page import Pages
from freebody.present.plane_page import note_on, page
from freebody.present.scene import Scene
from freebody.present.video import ffmpeg

if TYPE_CHECKING:
    from freebody.present.stage import Show

RATE = 30  # frames a second of shown time
GIF_RATE = 25  # GIF counts hundredths of a second
N_FRAMES = 3000
FEWEST = 120  # of a page, which can be slowed down
_INCHES, _DPI = 6.4, 100


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
    """Writes a motion as `.html` (one page with controls, no network), `.gif` or `.mp4`, by the suffix of the path,
    which it returns. The motion as for `film_of`. Raises InputError as that does, and if the suffix is another one, the
    file cannot be written, or there is no ffmpeg for an MP4."""
    return write_film(film_of(scene, times, poses, title=title, speed=speed, contacts=contacts), path)


def film_of(
    scene: Scene,
    times: Array,
    poses: Array,
    *,
    title: str,
    speed: float = 1.0,
    contacts: ContactTrack | None = None,
) -> Film:
    """A motion as a film.

    times: (n_times,) [s], ascending, a repeated time counts once (its last pose). poses: (n_times, n_moving_bodies,
    3), x and y of the mass centre [m] and the angle [rad], continuous, in the order of `scene.names`. speed: seconds
    of motion in a second of showing. contacts: where bodies touch at the given times, to be marked. Raises InputError
    if these do not fit together."""
    motion = _checked(scene, times, poses, contacts)

    def show(n_frames: int) -> tuple[Show, Array]:
        from freebody.present.stage import show_of_plane  # a page needs no labels set in pixels

        drawing, shown = motion.drawn(scene, n_frames)
        return show_of_plane(drawing, note_on(drawing)), shown

    def page_of(n_frames: int) -> Pages:
        drawing, shown = motion.drawn(scene, n_frames)
        return page(drawing, shown, title)

    return Film(motion.times, title, speed, show, page_of)


@dataclass(frozen=True, repr=False)
class Film:
    """A motion that can be shown. times: (n_times,) [s] at which it is given; speed: seconds of motion in a second of
    showing; show, page: of so many frames the drawing with their times, equally spaced, and the page that plays them;
    fewest: frames of a page, at least; tell: a message in the language of the page"""

    times: Array
    title: str
    speed: float
    show: Callable[[int], tuple[Show, Array]]
    page: Callable[[int], Pages]
    fewest: int = FEWEST + 1
    tell: Callable[[str], str] = str
    language: str = "en"

    def __post_init__(self) -> None:
        if not (math.isfinite(self.speed) and self.speed > 0):
            raise InputError(f"the speed of an animation is a positive number, not {self.speed}")

    def __repr__(self) -> str:
        return f"<Film {self.title!r}: {self.times[0]:.4g} s to {self.times[-1]:.4g} s>"

    def _repr_html_(self) -> str:
        """For notebooks: the page that plays it, in a frame of its own."""
        look = "width: 100%; height: 34rem; border: 0"
        return f'<iframe srcdoc="{escape(self.text())}" sandbox="allow-scripts" style="{look}"></iframe>'

    def write(self, path: str | Path) -> Path:
        """Writes it as `.html`, `.gif` or `.mp4`, by the suffix of the path, which it returns. Raises InputError for
        another suffix, a file that cannot be written, or an MP4 without ffmpeg."""
        return write_film(self, path)

    def n_frames(self, rate: int) -> int:
        """Of a film at a rate [1/s]."""
        return min(N_FRAMES, math.ceil((self.times[-1] - self.times[0]) / self.speed * rate - 1e-9) + 1)

    def text(self) -> str:
        """The text of a page that plays it."""
        page = self.page(min(N_FRAMES, max(self.fewest, self.n_frames(RATE))))
        return page.text(self.title, self.speed, self.tell, self.language)

    def stages(self, rate: int) -> tuple[Any, Iterator[None]]:
        """A figure, and an iterator that brings it to one frame after the other, at a rate [1/s]."""
        from freebody.present.stage import Stage

        show, shown = self.show(self.n_frames(rate))
        stage = Stage.of(show, _INCHES, title=self.title, tell=self.tell)
        clock = stage.figure.text(0.97, 0.03, "", ha="right", va="bottom", fontsize=9, color=stage.theme.muted)

        def stages() -> Iterator[None]:
            for frame, t in enumerate(shown):
                artists = stage.paint(frame)
                clock.set_text(self.tell(Message("t = {t:.2f} s", t=float(t))))
                yield
                for artist in artists:
                    artist.remove()

        return stage.figure, stages()


def write_film(film: Film, path: str | Path) -> Path:
    """As `Film.write`."""
    path = Path(path)
    writers: dict[str, Callable[[Path], None]] = {
        ".html": lambda file: _written(file, film.text()),
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
    if len(times) == 1:
        return times, poses
    shown: Array = np.linspace(float(times[0]), float(times[-1]), n_frames)
    given = np.searchsorted(times, shown)
    if np.array_equal(times[given], shown):  # SciPy's splines take longer to import than a motion to find
        return shown, poses[given]
    from scipy.interpolate import PchipInterpolator

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
    program = ffmpeg()  # first, because drawing takes long
    figure, stages = film.stages(RATE)
    matplotlib: Any = importlib.import_module("matplotlib")
    animation: Any = importlib.import_module("matplotlib.animation")
    with matplotlib.rc_context({"animation.ffmpeg_path": program}):
        writer = animation.FFMpegWriter(fps=RATE, codec="h264", extra_args=["-pix_fmt", "yuv420p"])
        with writer.saving(figure, str(path), _DPI):
            for _ in stages:
                writer.grab_frame()


def _pictures(figure: Any, stages: Iterator[None]) -> Iterator[Any]:
    """(height, width, 3) bytes of each frame."""
    for _ in stages:
        figure.canvas.draw()
        yield np.asarray(figure.canvas.buffer_rgba())[:, :, :3].copy()
