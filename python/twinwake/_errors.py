"""What goes wrong, in plain words: what was found, what was expected, what to do."""


class TwinwakeError(Exception):
    """A file that is no run record, is damaged, or has no such table; a scene that cannot be written; no program."""


class ProgramError(TwinwakeError):
    """The program ended with an error: `message` is what it said, `status` its exit status.

    2: bad input or usage; 3: a run failed or was stopped, and its state is saved; 4: --require agree is not met.
    """

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status
        self.message = message
