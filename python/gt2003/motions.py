"""Motion nets: the special actions, compiled from motion descriptions (`.mof`).

    net = gt2003.motions.compile().checked()
    played = gt2003.motions.play(net, "pushStrong")
    played.joints[:, 0]
"""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from . import _core, modules
from ._error import Error
from .representations import JointData, MotionInfo, MotionNet, MotionRequest, MotionType

__all__ = ["Compilation", "Diagnostic", "Played", "compile", "listing", "names", "play"]

_FRAME = 8  # ms


@dataclass(frozen=True)
class Diagnostic:
    """What is wrong in a motion description."""

    file: str
    line: int
    """From 1; 0: the whole file."""
    field: str
    message: str

    def __str__(self) -> str:
        return str(Error(self.message, self.file, self.line, self.field))


@dataclass(frozen=True)
class Compilation:
    """A net, if there is no error, and all errors."""

    net: MotionNet | None
    diagnostics: list[Diagnostic]

    def checked(self) -> MotionNet:
        """Return the net; raise the first error if there is none."""
        if self.net is not None:
            return self.net
        first = self.diagnostics[0]
        raise Error(first.message, first.file, first.line, first.field)


@dataclass(frozen=True)
class Played:
    """What a robot's joints are told while it performs a motion, in frames of 8 ms."""

    joints: npt.NDArray[np.float64]
    """(frames, joints): rad, in the order of `representations.JointData.angles`."""
    complete: bool
    """Whether the net was left at the end."""


def compile(
    folder: str | os.PathLike[str] = "", *, files: dict[str, str] | None = None
) -> Compilation:
    """Compile all descriptions of a folder (the robots' own, if none is named), or of `files`.

    These are texts by the names of the files.
    """
    if files is not None:
        made, errors = _core._compile_motions(list(files.items()))
    else:
        made, errors = _core._compile_motion_folder(os.fspath(folder) or _core._data_path("motions"))
    return Compilation(made, [Diagnostic(*error) for error in errors])


def names(net: MotionNet) -> list[str]:
    """Return the names of a net's motions."""
    return [motion.name for motion in net.motions if motion.name]


def listing(net: MotionNet) -> str:
    """Return the motions as an enumeration of XABSL, as `motionnet list` writes it."""
    return _core._list_motions(names(net))


def play(
    net: MotionNet, motion: str, *, joints: npt.ArrayLike | None = None, seconds: float = 20
) -> Played:
    """Perform a motion once, from extern until the net is left again, or for so many seconds.

    `joints` are the angles before it (rad). It is done by the robots' own module.
    """
    if motion not in names(net):
        raise Error(f"the net has no motion {motion}", field="motion")
    if not 0 < seconds <= 3600:
        raise Error("must be above 0, and at most 3600", field="seconds")
    module = modules.Module("SpecialActions", "GT2003MotionNet")
    now = JointData()
    if joints is not None:
        now.angles = np.asarray(joints)
    request = MotionRequest(type=MotionType.specialAction, specialAction=motion)
    info = MotionInfo()
    info.executed = request
    output = module.update(motion_net=net, motion_request=request, motion_info=info, joint_data=now)
    frames = []
    for frame in range(1, int(seconds * 1000 / _FRAME) + 1):
        if output.dontCare.all():
            break
        now.angles = np.where(output.dontCare, now.angles, output.joints.angles)
        frames.append(now.angles)
        output = module.update(
            motion_request=MotionRequest(), joint_data=now, frame_info={"time": frame * _FRAME}
        )
    joints_told = np.array(frames).reshape(len(frames), len(now.angles))
    return Played(joints_told, bool(output.dontCare.all()))
