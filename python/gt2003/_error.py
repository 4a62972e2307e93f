"""The exception of the package."""


class Error(Exception):
    """What is wrong with what was given, and where.

    Prints as one line, ``file:line: field: what``; parts that are not known are left out.
    """

    def __init__(self, what: str, file: str = "", line: int = 0, field: str = "") -> None:
        super().__init__(what, file, line, field)
        self.what = what
        self.file = file
        self.line = line
        self.field = field

    def __str__(self) -> str:
        place = self.file + (f":{self.line}" if self.line else "")
        return ": ".join(part for part in (place, self.field, self.what) if part)
