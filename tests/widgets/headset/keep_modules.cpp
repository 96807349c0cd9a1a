// Loaded before a program whose leaks are looked for: OpenGL's driver is unloaded before that, and what it has left
// would be nobody's.
extern "C" int dlclose(void* /*library*/) { return 0; }
