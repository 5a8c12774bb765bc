#include "app/plant_grower.h"

#include "engine/mesh/make_mesh.h"
#include "engine/variation/growth.h"

#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace tractus {

static Result<Mesh> grown(WantedPlant const& wanted)
{
    auto const scene = TRY(apply_edit(*wanted.scene, wanted.growth));
    auto const plan = TRY(plan_growth(scene));
    Grower grower(plan);
    return make_mesh(grower.grow({ wanted.growth.seed, 0 }, wanted.growth.age));
}

// Everything but the thread is guarded by the mutex.
struct PlantGrower::Shared {
    void run();
    void grow_wanted(std::unique_lock<std::mutex>& lock);

    std::mutex mutex;
    std::condition_variable changed;
    std::optional<WantedPlant> wanted;  // That nobody has begun to grow.
    std::optional<Result<Mesh>> result; // The newest that was not taken.
    bool is_at_work = false;
    bool stop = false;
    std::thread thread;
};

void PlantGrower::Shared::run()
{
    std::unique_lock lock(mutex);
    for (;;) {
        changed.wait(lock, [&] { return stop || wanted; });
        if (stop)
            return;
        grow_wanted(lock);
    }
}

void PlantGrower::Shared::grow_wanted(std::unique_lock<std::mutex>& lock)
{
    std::optional<Result<Mesh>> plant;
    is_at_work = true;
    {
        auto const taken = *std::exchange(wanted, std::nullopt);
        lock.unlock();
        plant.emplace(grown(taken));
    }
    lock.lock();
    result.swap(plant);
    is_at_work = false;
    changed.notify_all();
}

PlantGrower::PlantGrower()
    : shared_(std::make_unique<Shared>())
{
    try {
        shared_->thread = std::thread(&Shared::run, shared_.get());
    } catch (std::system_error const&) {
        // The system gives no thread: grow() does it all, and the window waits.
    }
}

PlantGrower::~PlantGrower()
{
    {
        std::lock_guard const lock(shared_->mutex);
        shared_->stop = true;
    }
    shared_->changed.notify_all();
    if (shared_->thread.joinable())
        shared_->thread.join();
}

void PlantGrower::grow(WantedPlant wanted)
{
    std::unique_lock lock(shared_->mutex);
    shared_->wanted = std::move(wanted);
    if (shared_->thread.joinable())
        shared_->changed.notify_all();
    else
        shared_->grow_wanted(lock);
}

bool PlantGrower::is_growing() const
{
    std::lock_guard const lock(shared_->mutex);
    return shared_->wanted || shared_->is_at_work || shared_->result;
}

std::optional<Result<Mesh>> PlantGrower::take()
{
    std::lock_guard const lock(shared_->mutex);
    return std::exchange(shared_->result, std::nullopt);
}

void PlantGrower::settle()
{
    std::unique_lock lock(shared_->mutex);
    shared_->changed.wait(lock, [&] { return !shared_->wanted && !shared_->is_at_work; });
}

} // namespace tractus
