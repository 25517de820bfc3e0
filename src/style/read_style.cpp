// SPDX-License-Identifier: Apache-2.0
#include "style/read_parts.h"
#include "style/source_check.h"

#include <kushi/head.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <system_error>

namespace kushi {

namespace {

constexpr std::int64_t formatVersion = 1;

// Whether the rest can be read: a newer format may mean other things by the same keys.
bool readVersion(const Node& root, Diagnostics& problems) {
    const Entry* version = root.find("kushi");
    if (version == nullptr) {
        problems.add(0, "the style has no 'kushi', expected the format version, kushi = 1");
        return true;
    }
    const Node& value = version->value;
    if (value.kind != Kind::Integer || value.integer() < 1) {
        problems.unexpected("kushi", value, "1, the version of the format");
        return true;
    }
    if (value.integer() == formatVersion) return true;
    problems.add(value.begin, "this style is written for Kushi format " +
                                  std::to_string(value.integer()) + "; this program reads format " +
                                  std::to_string(formatVersion) + ": get a newer Kushi");
    return false;
}

Solver readSolver(const Node& node, ReadContext& context) {
    const TableReader table(node, tables::solver, context);
    Solver solver;
    table.choice<Method>("method",
                         {{"cantilever", Method::Cantilever}, {"equilibrium", Method::Equilibrium}},
                         solver.method);
    table.number("grading", quantities::grading, solver.grading);
    if (solver.method == Method::Cantilever && solver.grading != 1) {
        context.problems.add(node.find("grading")->at,
                             "'grading' is not for the cantilever method; write method = "
                             "\"equilibrium\" beside it");
    }
    if (const auto segments = table.whole("segments", 1, 256)) {
        solver.segments = static_cast<int>(*segments);
    }
    if (const auto steps = table.whole("avoidance_steps", 1, 16)) {
        solver.avoidanceSteps = static_cast<int>(*steps);
    }
    return solver;
}

// What the paper's walk does not know.
void refuseInWalk(const Entry& entry, Diagnostics& problems) {
    problems.add(entry.at, '\'' + entry.key +
                               "' is not for the cantilever method; write method = "
                               "\"equilibrium\" in [solver]");
}

void readTies(const TableReader& table, Part& part) {
    ReadContext& context = table.context();
    for (const Node* node : table.tables("tie", tables::tie)) {
        const HairTie tie = readTie(*node, context);
        if (part.groom) {
            context.problems.add(node->begin,
                                 "a tie is for hair that grows; a groom stays where it is");
        } else if (isFinite(tie.at) && part.scalp.ellipsoid.implicit(tie.at) <= 0) {
            context.problems.add(node->begin,
                                 "the tie lies inside the scalp's ellipsoid, where no hair goes; "
                                 "move `at` away from its centre");
        }
        part.ties.push_back(tie);
    }
    if (const Entry* entry = table.node().find("tie"); entry != nullptr && context.walks)
        refuseInWalk(*entry, context.problems);
}

// The tables of a part, which stand in [[part]] or, where there is only one, at the top.
Part readTables(const TableReader& table) {
    ReadContext& context = table.context();
    Part part;
    table.requireOne("scalp", "groom", context.label(tables::scalp));
    const bool grows = table.has("scalp") || !table.has("groom");
    if (const Node* scalp = table.table("scalp", tables::scalp)) {
        part.scalp = readScalp(*scalp, context);
    }
    if (const Entry* groom = table.node().find("groom")) {
        part.groom = readGroomSource(*groom, context);
        part.scalp.ellipsoid = headEllipsoid();
        if (context.walks) refuseInWalk(*groom, context.problems);
    }
    if (grows) table.require("hair", context.label(tables::hair));
    if (const Node* hair = table.table("hair", tables::hair)) {
        part.hair = readHair(*hair, grows, context);
        for (const char* key : {"curl", "wave", "taper"}) {
            const Entry* entry = hair->find(key);
            if (entry != nullptr && grows && context.walks) refuseInWalk(*entry, context.problems);
        }
    }
    for (const Node* force : table.tables("force", tables::force)) {
        part.forces.push_back(readForce(*force, context));
    }
    for (const Node* cut : table.tables("cut", tables::cut)) {
        part.cuts.push_back(readCut(*cut, context));
    }
    for (const Node* highlight : table.tables("highlight", tables::highlight)) {
        part.highlights.push_back(readHighlight(*highlight, context));
    }
    readTies(table, part);
    return part;
}

std::string defaultName(std::size_t index) {
    return index == 0 ? "hair" : "hair " + std::to_string(index + 1);
}

Part readPart(const Node& node, std::size_t index, ReadContext& context) {
    const TableReader table(node, tables::part, context);
    Part part = readTables(table);
    part.name = defaultName(index);
    table.text("name", part.name);
    return part;
}

void checkName(const std::string& name, const Node& part, std::set<std::string>& taken,
               Diagnostics& problems) {
    const Entry* entry = part.find("name");
    const std::size_t place = entry != nullptr ? entry->value.begin : part.begin;
    if (name.empty()) {
        problems.add(place, "name: found an empty name, expected one to tell the parts by");
    } else if (!taken.insert(name).second) {
        problems.add(place, "name: found a second part called \"" + excerpt(name) +
                                "\", expected a name of its own");
    }
}

void readParts(const TableReader& top, Style& style) {
    ReadContext& context = top.context();
    const Node* part = top.find("part");
    if (part == nullptr) {
        if (context.partAtTop) {
            style.parts.push_back(readTables(top));
            style.parts.back().name = defaultName(0);
        } else {
            context.problems.add(
                0, "the style has no hair, expected [[part]] with [part.scalp] and [part.hair]");
        }
        return;
    }
    for (const std::string_view key : keysOfPart) {
        if (const Entry* entry = top.node().find(key)) {
            context.problems.add(entry->value.begin,
                                 '\'' + std::string(key) +
                                     "' stands at the top, but the style has [[part]]; it belongs "
                                     "in one of the parts, as part." +
                                     std::string(key));
        }
    }
    std::set<std::string> taken;
    for (const Node* node : top.tables("part", tables::part)) {
        style.parts.push_back(readPart(*node, style.parts.size(), context));
        checkName(style.parts.back().name, *node, taken, context.problems);
    }
    if (part->kind == Kind::Array && part->items.empty()) {
        context.problems.unexpected("part", *part, "at least one [[part]]");
    }
}

void readTop(const TableReader& table, Style& style) {
    table.text("name", style.name);
    if (const auto seed = table.whole("seed", 0, std::numeric_limits<std::int64_t>::max())) {
        style.seed = static_cast<std::uint64_t>(*seed);
    }
    table.vector("gravity", quantities::gravity, style.gravity);
    // Before the parts, wherever it stands: they name heights of the head.
    if (const Node* head = table.table("head", tables::head)) {
        readHead(*head, table.context(), style);
    }
    for (const Node* collider : table.tables("collider", tables::collider)) {
        style.colliders.push_back(readCollider(*collider, table.context()));
    }
    if (const Node* contact = table.table("contact", tables::contact)) {
        style.contact = readContact(*contact, table.context());
    }
    if (const Node* solver = table.table("solver", tables::solver)) {
        style.solver = readSolver(*solver, table.context());
    }
    table.context().headless = style.headMesh == "none";
    table.context().walks = style.solver.method == Method::Cantilever;
    readParts(table, style);
}

Result<std::string> readText(const std::string& path) {
    const auto reason = [] { return std::generic_category().message(errno); };
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        return Problem{"found a directory, expected a style file", path};
    }
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) return Problem{"cannot open the style: " + reason(), path};

    // One byte past the limit is enough to refuse the rest.
    std::string text(longestStyle + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) return Problem{"cannot read the style: " + reason(), path, 0, 0, true};
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

}  // namespace

bool keepsPartAtTop(const Node& root) {
    if (root.find("part") != nullptr) return false;
    return std::ranges::any_of(keysOfPart,
                               [&](std::string_view key) { return root.find(key) != nullptr; });
}

Result<Style> parseStyle(std::string_view text, const std::string& file) {
    const Result<Document> document = parseDocument(text, file);
    if (!document) return document.problems();

    Diagnostics problems(*document, file);
    const std::string folder = std::filesystem::path(file).parent_path();
    ReadContext context = {problems, keepsPartAtTop(document->root), folder, {}, true, false};
    Style style;
    if (readVersion(document->root, problems)) {
        readTop(TableReader(document->root, tables::top, context), style);
    }
    if (!problems.empty()) return problems.take();
    return style;
}

Result<Style> readStyle(const std::string& path) {
    Result<std::string> text = readText(path);
    if (!text) return text.problems();
    return parseStyle(*text, path);
}

}  // namespace kushi
