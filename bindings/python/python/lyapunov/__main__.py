"""The command `lyapunov`."""

import sys

from lyapunov._lyapunov import command


def main() -> int:
    """Runs the command that the arguments ask for."""
    return command(["lyapunov", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
