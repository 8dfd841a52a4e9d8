"""What the example programs share: models and pictures made by code, files, steps, tables, drawing."""
