// Attack: is nothing but comments.
// Verdict: wrong signature

// Nothing else.
