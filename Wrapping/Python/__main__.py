"""python3 -m conformalsom: the command conformalsom."""
import sys

from conformalsom.command.main import main

sys.exit(main())
