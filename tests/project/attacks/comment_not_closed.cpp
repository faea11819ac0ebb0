// Attack: never ends its comment.
// Verdict: does not compile | wrong signature

/* Here starts what never ends.
