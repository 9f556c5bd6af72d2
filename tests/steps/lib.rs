//! Nothing: the test target `steps` of this package is all of it.
