// The same operations on wider registers have the same bits, so each machine may use its own.
#pragma once

// Compiles a function for each of the named instruction sets and has the processor choose. Not
// where a sanitizer is not yet ready when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define SURPASS_FOR_EACH_MACHINE(...) [[gnu::target_clones(__VA_ARGS__)]]
#else
#define SURPASS_FOR_EACH_MACHINE(...)
#endif
