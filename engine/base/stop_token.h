#pragma once

#include <glissade/stop_token.h>  // public: programs stop the library by the tokens that the engine reads
