// Fontconfig keeps what it read of the system's fonts until the end, where some of it can no longer
// be reached: no leak of ours. The name is the leak sanitizer's own.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
