"""Files that scripts write in place: whole, or not at all."""
import os


def write(path, text):
    """Write a file under another name, which it loses when it is whole; what was there before stays if that fails."""
    written = os.path.realpath(path) + ".part"
    try:
        with open(written, "w", encoding="utf-8") as file:
            file.write(text)
        if os.path.exists(path):
            os.chmod(written, os.stat(path).st_mode)
        os.replace(written, os.path.realpath(path))
    except OSError:
        if os.path.exists(written):
            os.remove(written)
        raise
