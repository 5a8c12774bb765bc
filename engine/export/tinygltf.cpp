// The one place where tinygltf is compiled.
#define TINYGLTF_IMPLEMENTATION
#include <fstream> // tinygltf writes files, whatever it is told; we never call that.

#include "engine/export/tinygltf.h"
