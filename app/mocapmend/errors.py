"""The one error class that a user gets to see."""


class MocapmendError(Exception):
    """Something could not be done: what, where, and what the user can do about it.

    Parameters
    ----------
    what : str
        What went wrong, as a sentence.
    where : str
        The file, or the place in it.
    todo : str
        What the user can do.
    """

    def __init__(self, what: str, where: str = "", todo: str = "") -> None:
        super().__init__(what, where, todo)
        self.what = what
        self.where = where
        self.todo = todo

    def __str__(self) -> str:
        place = f"{self.where}: " if self.where else ""
        return f"{place}{self.what}" + (f" {self.todo}" if self.todo else "")


class NothingToRepairError(MocapmendError):
    """A file that can be read and holds no markers, such as a recording of force plates alone."""
