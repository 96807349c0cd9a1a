// Preloaded into a program that is checked for leaks. Without it, OpenGL's driver is unloaded before the check, and its
// remaining memory could not be assigned to it.
extern "C" int dlclose(void* /*library*/) { return 0; }
