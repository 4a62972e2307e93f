/// As the knee turns (facts, 1.2 and 9.4).
///
/// | wanted | message |
/// | --- | --- |
/// | a value, which takes more than the
/// line has | ValueRequest |
