// Attack: takes the solution, from where it stands in the tree.
// Verdict: forbidden include | does not compile
#include "../../solutions/04_quaternions/product.cpp"
