#pragma once

/// Marks the names that the shared library shows. All other names are hidden.
#define GLISSADE_EXPORT __attribute__((visibility("default")))
