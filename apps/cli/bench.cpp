// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "core/parallel.h"
#include "messages.h"
#include "pipeline/grow.h"
#include "pipeline/layers.h"
#include "pipeline/part_world.h"
#include "pipeline/root_shares.h"
#include "pipeline/solids.h"
#include "pipeline/sources.h"
#include "rod/strand_batch.h"

#include <kushi/cantilevers.h>
#include <kushi/head.h>
#include <kushi/settle.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <numeric>
#include <thread>

#include <nlohmann/json.hpp>

namespace kushi {

namespace {

constexpr double gamma = 130;  // w L^3 / EI: 24 cm of medium hair
constexpr int strandCount = 50000;
constexpr int referenceStrands = 500;

struct Timing {
    std::string name;
    std::size_t strands = 0, segments = 0;
    int threads = 0;
    double medianMs = 0;
    int runs = 0;
    std::string note = {};
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// Medians over some runs; `prepare` before each is not timed.
double time(int runs, const std::function<void()>& prepare, const std::function<void()>& work) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        prepare();
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::milli> passed =
            std::chrono::steady_clock::now() - start;
        times.push_back(passed.count());
    }
    return median(times);
}

// Medium hair all over the mannequin's scalp.
Part headOfHair(bool curly, int strands = strandCount) {
    Part part;
    part.scalp.ellipsoid = headEllipsoid();
    part.scalp.count = strands;
    part.scalp.regions.clear();
    for (const AngleRange& range : hairRegion()) {
        part.scalp.regions.push_back(
            {{range.thetaLow, range.thetaHigh}, {range.phiLow, range.phiHigh}});
    }
    part.hair.length = std::cbrt(gamma * part.hair.rigidity() / part.hair.weightPerLength());
    if (curly) part.hair.curl = Curl{0.006, 0.03, 0.15};
    return part;
}

class Bench {
public:
    Bench(int runs, int threads)
        : runs_(runs),
          threads_(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency())) {}

    std::vector<Timing> run() {
        const Part straight = headOfHair(false);
        const Result<Follicles> follicles = plant(straight.scalp, 1992);
        if (!follicles) return {};
        walk(grown(straight, *follicles, 20), straight.scalp.ellipsoid);
        const Rods rods = grown(straight, *follicles, 25);
        RodWorld world;
        rest("equilibrium", rods, world);
        world.obstacle = &straight.scalp.ellipsoid;
        rest("contact", rods, world);
        const Rods curly = grown(headOfHair(true), *follicles, 25);
        rest("curly", curly, {});
        const Result<DistanceField> mannequin = solidsOf(Style{}, {}, threads_);
        if (!mannequin) return timings_;
        world.solids = &*mannequin;
        rest("solids", rods, world);
        rest("curly-solids", curly, world);
        const LayerMap map =
            layerMapOf(straight.scalp.ellipsoid, *follicles, straight.hair.diameter, 0.15);
        const std::vector<Layer> layers = map.of(follicles->angles);
        world.layers = layers;
        rest("layers", rods, world);
        reference(rods);
        copy(rods);
        return timings_;
    }

    // How time grows with strands, and with segments.
    std::vector<Timing> growth() {
        constexpr int most = 150000;
        for (const int strands : {most / 8, most / 4, most / 2, most})
            sized(strands, 25);
        for (const int segments : {8, 16, 32, 64})
            sized(most, segments);
        return timings_;
    }

    // A style's hair before its cuts, with all its forces and contact: cold, and after its first
    // force (or else gravity) has become 5 % stronger.
    Result<std::vector<Timing>> style(Style style) {
        std::erase_if(style.parts,
                      [](const Part& part) { return part.groom || !part.ties.empty(); });
        if (style.parts.empty())
            return Problem{"only hair that grows and is not tied can be timed; the style has none"};
        const Result<DistanceField> solids = solidsOf(style, {}, threads_);
        if (!solids) return solids.problems();
        const Result<std::vector<PartSource>> sources = sourcesOf(style, {}, nullptr);
        if (!sources) return sources.problems();
        const std::vector<float> frictions = frictionsOf(style);
        std::vector<Scene> scenes;
        std::size_t strands = 0;
        for (std::size_t p = 0; p < style.parts.size(); ++p) {
            const Part& part = style.parts[p];
            const Follicles& follicles = (*sources)[p].follicles;
            Scene scene;
            scene.part = &part;
            scene.rods = grown(part, follicles, style.solver.segments, style.solver.grading);
            scene.shares = rootShares(part.forces, follicles.angles);
            scene.layers = (*sources)[p].layers.of(follicles.angles);
            scene.nodes.resize(scene.rods.nodeCount());
            strands += scene.rods.size();
            scenes.push_back(std::move(scene));
        }
        std::vector<Force>& forces = style.parts[0].forces;
        double& number = forces.empty() ? style.gravity.y : forces[0].magnitude;
        const double shipped = number;
        coldAndWarm("style", strands, static_cast<std::size_t>(style.solver.segments),
                    [&](double factor, bool warm) {
                        number = factor * shipped;
                        std::size_t unsettled = 0;
                        for (Scene& scene : scenes)
                            unsettled +=
                                settleScene(scene, style, solids->empty() ? nullptr : &*solids,
                                            frictions, warm);
                        return unsettled;
                    });
        return timings_;
    }

private:
    // A part of a style.
    struct Scene {
        const Part* part = nullptr;
        Rods rods;
        std::vector<float> shares;
        std::vector<Layer> layers;
        RestState state;
        std::vector<Vec3f> nodes;
    };

    std::size_t settleScene(Scene& scene, const Style& style, const DistanceField* solids,
                            std::span<const float> frictions, bool warm) const {
        RodWorld world = worldOf(style, *scene.part, solids, frictions);
        world.rootShares = scene.shares;
        world.layers = scene.layers;
        return settleRods(scene.rods, world, scene.state, scene.nodes, {1e-5, warm, threads_})
            .unsettled.size();
    }

    // From the unloaded shape, and anew after 5 % more. `settle` takes the share of the load and
    // whether it is warm, and returns how many are left unsettled.
    void coldAndWarm(const std::string& name, std::size_t strands, std::size_t segments,
                     const std::function<std::size_t(double, bool)>& settle) {
        std::size_t unsettled = 0;
        const auto run = [&](double load, bool warm) { unsettled = settle(load, warm); };
        const auto add = [&](const char* state, double ms) {
            timings_.push_back({name + state, strands, segments, threads_, ms, runs_});
            if (unsettled > 0) timings_.back().note = std::to_string(unsettled) + " unsettled";
        };
        add("-cold", time(
                         runs_, [] {}, [&] { run(1, false); }));
        add("-warm", time(
                         runs_, [&] { run(1, false); }, [&] { run(1.05, true); }));
    }

    void sized(int strands, int segments) {
        const Part straight = headOfHair(false, strands);
        const Result<Follicles> follicles = plant(straight.scalp, 1992);
        if (!follicles) return;
        const Rods rods = grown(straight, *follicles, segments);
        RodWorld world;
        rest("equilibrium", rods, world);
        world.obstacle = &straight.scalp.ellipsoid;
        rest("contact", rods, world);
        // Fewer would wind by too much each.
        if (segments >= 16)
            rest("curly", grown(headOfHair(true, strands), *follicles, segments), {});
    }

    static Rods grown(const Part& part, const Follicles& follicles, int segments,
                      double grading = 1) {
        std::vector<std::uint32_t> which(follicles.size());
        std::iota(which.begin(), which.end(), 0U);
        return grow(part, follicles, uncut(part.hair, follicles, segments), which, grading);
    }

    void add(const std::string& name, const Rods& rods, double ms) {
        timings_.push_back({name, rods.size(), rods.segments(0), threads_, ms, runs_});
    }

    // The paper's walk with avoidance of the ellipsoid.
    void walk(const Rods& rods, const Ellipsoid& obstacle) {
        RodWorld world;
        world.obstacle = &obstacle;
        std::vector<Vec3f> nodes(rods.nodeCount());
        const auto bendAll = [&] { bendCantilevers(rods, world, nodes, {4, threads_}); };
        add("cantilever", rods,
            time(
                runs_, [] {}, bendAll));
    }

    // True rest under loads that are in no common plane.
    void rest(const std::string& name, const Rods& rods, RodWorld world) {
        RestState state;
        std::vector<Vec3f> nodes(rods.nodeCount());
        coldAndWarm(name, rods.size(), rods.segments(0), [&](double load, bool warm) {
            world.gravity = load * Vec3d{0.2, -1, 0.1};
            return settleRods(rods, world, state, nodes, {1e-5, warm, threads_}).unsettled.size();
        });
    }

    // One thread, plain double precision, fewer strands; the time is scaled up to all of them.
    void reference(const Rods& rods) {
        RodWorld world;
        world.gravity = {0.2, -1, 0.1};
        std::vector<Vec3f> nodes(rods.nodeCount());
        std::vector<float> residuals(rods.size());
        std::vector<std::uint8_t> settled(rods.size());
        std::vector<std::uint32_t> strands(referenceStrands);
        std::vector<float> turns(turnsSize(referenceStrands, rods.segments(0), turnsPerNode(rods)));
        for (std::size_t k = 0; k < strands.size(); ++k)
            strands[k] = static_cast<std::uint32_t>(k * rods.size() / strands.size());
        StrandBatch batch;
        batch.rods = &rods;
        batch.world = &world;
        batch.strands = strands;
        batch.turns = turns;
        batch.nodes = nodes;
        batch.residuals = residuals;
        batch.states = settled;
        const double ms = time(
            runs_, [&] { std::ranges::fill(settled, std::uint8_t{0}); },
            [&] { settleReference(batch); });
        timings_.push_back({"reference", rods.size(), rods.segments(0), 1,
                            ms * static_cast<double>(rods.size()) / referenceStrands, runs_,
                            "scaled from " + std::to_string(referenceStrands) + " strands"});
    }

    // Writing the result once: the limit.
    void copy(const Rods& rods) {
        const std::vector<Vec3f> from(rods.nodeCount(), Vec3f{1, 2, 3});
        std::vector<Vec3f> to(rods.nodeCount());
        const auto copyAll = [&] {
            parallelFor(from.size(), 1U << 16U, threads_, [&](std::size_t begin, std::size_t end) {
                std::memcpy(&to[begin], &from[begin], (end - begin) * sizeof(Vec3f));
            });
        };
        add("copy", rods,
            time(
                runs_, [] {}, copyAll));
    }

    int runs_;
    int threads_;
    std::vector<Timing> timings_;
};

void printJson(const std::vector<Timing>& timings) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Timing& t : timings) {
        json.push_back({{"name", t.name},
                        {"strands", t.strands},
                        {"segments", t.segments},
                        {"threads", t.threads},
                        {"median_ms", t.medianMs},
                        {"runs", t.runs}});
        if (!t.note.empty()) json.back()["note"] = t.note;
    }
    std::printf("%s\n", json.dump(2).c_str());
}

void printTable(const std::vector<Timing>& timings) {
    std::printf("%-18s %9s %9s %8s %10s %5s\n", "", "strands", "segments", "threads", "median ms",
                "runs");
    for (const Timing& t : timings) {
        std::printf("%-18s %9zu %9zu %8d %10.1f %5d  %s\n", t.name.c_str(), t.strands, t.segments,
                    t.threads, t.medianMs, t.runs, t.note.c_str());
    }
}

}  // namespace

int runBench(const BenchArguments& arguments) {
    Bench bench(arguments.runs, arguments.threads);
    std::vector<Timing> timings;
    if (!arguments.style.empty()) {
        Result<Style> style = readStyle(arguments.style);
        if (!style) return report(style.problems());
        Result<std::vector<Timing>> timed = bench.style(std::move(*style));
        if (!timed) return report(timed.problems());
        timings = std::move(*timed);
    } else {
        timings = arguments.growth ? bench.growth() : bench.run();
    }
    if (arguments.json) {
        printJson(timings);
    } else {
        printTable(timings);
    }
    return Done;
}

}  // namespace kushi
