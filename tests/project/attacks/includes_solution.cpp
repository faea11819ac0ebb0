// Attack: takes the solution, by its full path.
// Verdict: forbidden include
#include "@ROOT@/solutions/04_quaternions/product.cpp"
