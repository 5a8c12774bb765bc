#include "engine/base/vectors.h"

namespace tractus {

Quat rotation_between(Vec3 const& from, Vec3 const& to)
{
    return Quat::FromTwoVectors(from, to);
}

} // namespace tractus
