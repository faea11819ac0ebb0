// Attack: an error in each of a million lines, each of which quotes a long macro.
// Verdict: too expensive to compile | does not compile
#define A error error error error error error error error error error;
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
#define E D D D D D D D D D D
E

    namespace quaternions {
  Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
