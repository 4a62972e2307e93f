#pragma once

namespace gt {

#ifdef __x86_64__
template <typename Work>
[[gnu::target("avx2")]] void doWide(const Work& work) {
  work();
}
#endif

/// Does work on whole numbers with the widest instructions that the processor has: the same bits,
/// sooner. The work's operator() and all loops in it are always inlined.
template <typename Work>
void withWideInstructions(const Work& work) {
#ifdef __x86_64__
  static const bool wide = __builtin_cpu_supports("avx2");
  if (wide) return doWide(work);
#endif
  work();
}

}  // namespace gt
