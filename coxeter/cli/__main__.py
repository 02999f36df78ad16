"""``python -m coxeter.cli`` is ``coxeter``."""

import sys

from . import main

if __name__ == "__main__":
    sys.exit(main())
