// The only translation unit that compiles tinygltf's implementation.
#define TINYGLTF_IMPLEMENTATION
#include <fstream> // Needed by tinygltf's code for writing files, although it is never called.

#include "engine/export/tinygltf.h"
