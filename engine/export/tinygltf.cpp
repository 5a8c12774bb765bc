// The only translation unit that compiles tinygltf's implementation.
#define TINYGLTF_IMPLEMENTATION
#include <fstream> // tinygltf's code for writing files needs it, although we never call that.

#include "engine/export/tinygltf.h"
