#pragma once

#include "tests/physics/movement.h"
#include "tests/physics/potentiometer.h"

namespace tractus::physics {

// Movements of the drawing surface, between about 50 and 350 mm. They are random; times at which
// they are evaluated must not decrease. `dice` must outlive the movement.

// A surface that nobody moves.
Movement still();

// Rests and minimum-jerk movements of 0.25 to 2 s, one after the other, at up to 400 mm/s.
Movement drawing_hand(Dice& dice);

// Quick pushes of 2 to 80 mm, with rests in between: from 0.12 s for less than 10 mm, from 0.2 s
// for more, at up to 400 mm/s.
Movement hasty_hand(Dice& dice);

// A motorised desk: short and long runs at 25 to 50 mm/s, which the motor reaches within 50 to 300
// ms.
Movement motor(Dice& dice);

// A hand that drags a heavy surface with stick and slip through the spring of an arm, and lets it
// fall upon stops, from which it bounces. Mass, friction, stiffness and damping change every few
// seconds.
Movement rubbing_surface(Dice& dice);

// Adds tremor at 8 to 12 Hz with this standard deviation.
Movement trembling(Movement movement, double deviation_mm, Dice& dice);

} // namespace tractus::physics
