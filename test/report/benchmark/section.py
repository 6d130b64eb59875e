"""Published problems of other codes."""


def fields(data, draw):
    return {}
