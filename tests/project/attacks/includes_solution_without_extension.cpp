// Attack: includes the folder of the solutions by a path through the contract, with dots.
// Verdict: forbidden include | does not compile
#include "../exercises/../solutions/04_quaternions/product.cpp"
