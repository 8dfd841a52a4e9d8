"""python3 -m conformalsom: the command conformalsom."""
import sys

from conformalsom.command.main import main

if __name__ == "__main__":
    sys.exit(main())
