"""Environments for learning: ``GT2003/Walk-v0`` and others, by the interfaces of Gymnasium.

``import gt2003.envs`` registers them; docs/environments.md of the project describes each.
"""

from .._error import Error

try:
    import gymnasium
except ImportError as missing:
    raise Error("needs gymnasium: pip install 'gt2003[envs]'", field="gt2003.envs") from missing

from .. import _core
from ._single import Environment
from ._vector import VectorEnvironment

__all__ = ["Environment", "VectorEnvironment"]

for _known in _core.environments():
    gymnasium.register(
        id=f"GT2003/{_known['name']}-v0",
        entry_point="gt2003.envs:Environment",
        vector_entry_point="gt2003.envs:VectorEnvironment",
        kwargs={"environment": _known["name"]},
    )
