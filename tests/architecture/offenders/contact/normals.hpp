// Innocent.
