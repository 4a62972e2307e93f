"""GT2003 from Python: matches of simulated robots, their values, and their modules.

See docs/python.md of the project.
"""

from ._error import Error
from . import representations
from . import modules
from ._core import Match, Robot

__all__ = ["Error", "Match", "Robot", "modules", "representations"]
