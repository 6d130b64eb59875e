def check(cases):
    return []
