// Linked into every program of a sanitizer's build: leaks are looked for at the end, and a library
// that was closed by then, such as a graphics driver, would be told under another's name.

extern "C" int dlclose(void* /*library*/) { return 0; }
