#pragma once

namespace gt {

#ifdef __x86_64__
template <typename Work>
[[gnu::target("avx2")]] void doWide(const Work& work) {
  work();
}
#endif

/// Does work with the widest vector instructions of the processor. The results are bit for bit the
/// same, because nothing is contracted or summed in another order. The work's operator() and all
/// loops in it are always inlined.
template <typename Work>
void withWideInstructions(const Work& work) {
#ifdef __x86_64__
  static const bool wide = __builtin_cpu_supports("avx2");
  if (wide) return doWide(work);
#endif
  work();
}

}  // namespace gt
