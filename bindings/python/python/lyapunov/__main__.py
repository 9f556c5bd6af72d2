"""The command `lyapunov`."""

import signal
import socket
import sys
import threading

from lyapunov._lyapunov import command, interrupt


def heed() -> None:
    """Ends the command at an interrupt.

    Python's own handler only takes note of one, and threads of other libraries, as of NumPy's, may be those that get it.
    """
    told, tells = socket.socketpair()
    tells.setblocking(False)
    signal.set_wakeup_fd(tells.fileno(), warn_on_full_buffer=False)
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        # One that is ignored stays ignored, as `nohup` asks for.
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, lambda *_: None)

    def wait() -> None:
        with told, tells:
            told.recv(1)
            interrupt()

    threading.Thread(target=wait, name="interrupts", daemon=True).start()


def main() -> int:
    """Runs the command that the arguments ask for."""
    heed()
    return command(["lyapunov", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
