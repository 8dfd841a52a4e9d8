"""Tables of a study: CSV files in which each row belongs to a scan."""
import csv
import os


def rows_of(path, columns, names):
    """Rows of a table, each as its number, the name of its scan, and its cells in the order of the columns.

    The first of the columns is that of the scan, which may be called by its name or its file. Blank rows are left out.
    Raises ValueError for a file that is no such table, and for a scan that is not among the names.
    """
    with open(path, encoding="utf-8-sig", newline="") as file:
        try:
            rows = [row for row in csv.reader(file, strict=True) if any(cell.strip() for cell in row)]
        except (csv.Error, UnicodeDecodeError) as error:
            raise ValueError(f"{path}: not a CSV file in UTF-8: {error}") from None
    head = [cell.strip().lower() for cell in rows[0]] if rows else []
    if any(head.count(column) != 1 for column in columns):
        *first, last = columns
        raise ValueError(f"{path}: the first line must name the columns {', '.join(first)} and {last}")
    found = []
    for number, row in enumerate(rows[1:], 2):
        if len(row) != len(head):
            raise ValueError(f"{path}: row {number} has {len(row)} cells, but the first row has {len(head)}")
        cells = [row[head.index(column)].strip() for column in columns]
        base = os.path.basename(cells[0])
        name = base if base in names else os.path.splitext(base)[0]
        if name not in names:
            raise ValueError(f"{path}: {cells[0]} is none of the scans")
        found.append((number, name, cells))
    return found
