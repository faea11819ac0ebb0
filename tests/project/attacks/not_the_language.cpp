// Attack: is Python.
// Verdict: does not compile

def product(a, b) : return a * b
