"""What the command conformalsom is made of: arguments, steps, files, figures, pictures.

Needs NumPy, which the filters themselves do not.
"""
