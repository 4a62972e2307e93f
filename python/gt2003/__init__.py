"""GT2003 from Python: matches of simulated robots, their values, and their modules.

See docs/python.md of the project.
"""

from ._error import Error
from . import representations
from . import modules
from ._core import Match, Robot
from ._solution import Previous, SolutionFailure

__all__ = [
    "Error",
    "Match",
    "Previous",
    "Robot",
    "SolutionFailure",
    "modules",
    "representations",
]
