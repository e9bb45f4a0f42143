// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/Recipe.h"
#include "commands/recipe/RecipeLimits.h"
#include "model/io/ParametersJson.h"
#include "tests/commands/recipe/RecipeTexts.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class WrongRecipesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void wrongRecipes_nameThePlace_data();
    void wrongRecipes_nameThePlace();
    void wrongParameters_areAllRefusedJustBeyondTheirLimits();
    void hugeRecipes_areRefusedBeforeTheyAreParsed();
};

void WrongRecipesTest::wrongRecipes_nameThePlace_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("message");
    const auto row = [](const QByteArray& json, const char* message) {
        QTest::newRow(message) << json << QString::fromUtf8(message);
    };
    row("", "line 1: not valid JSON: ");
    row("[1]", "a JSON object is expected");
    row("{}", "this is not a recipe");
    row("{\"espalier-recipe\": 1,\n\n \"name\": nan}", "line 3: not valid JSON: ");
    row("{\"espalier-recipe\": 1, \"seed\": 1e999}", "line 1: not valid JSON: illegal number");
    row(R"({"espalier-recipe": 3, "new": 1})",
        "the recipe is of version 3; this program reads versions up to 2");
    row(R"({"espalier-recipe": "1"})", "espalier-recipe: a whole number");
    row(recipeOf(R"("nmae": "x")"), "“nmae” is not known here");
    row(recipeOf(R"("name": 5)"), "name: a string is expected");
    row(recipeOf(R"("seed": -1)"), "seed: a whole number of at most 64 bits");
    row(recipeOf(R"("seed": 1.5)"), "seed: a whole number of at most 64 bits is");
    row(recipeOf(R"("seed": "18446744073709551616")"), "seed: a whole number of at most 64 bits is expected");
    row(recipeOf(R"("seed": "1x")"), "seed: a whole number of at most 64 bits is expected;");
    row(recipeOf(R"("camera": {"view": "below"})"), "camera.view: there is no view “below”");
    row(recipeOf(R"("camera": {"zoom": 2})"), "camera: “zoom” is not known here");
    row(recipeOf(R"("camera": 5)"), "camera: an object is expected");
    row(recipeOf(R"("operations": {})"), "operations: an array is expected");
    row(operationsOf("5"), "operations[0]: an object is expected");
    row(operationsOf("{}"), "operations[0].op: it is missing");
    row(operationsOf(R"({"op": "grow", "steps": 1}, {"op": "mow"})"),
        "operations[1].op: there is no operation “mow”");
    row(operationsOf(R"({"op": "grow"})"), "operations[0].steps: it is missing");
    row(operationsOf(R"({"op": "grow", "steps": 0})"), "operations[0].steps: a whole number from 1 to 10000");
    row(operationsOf(R"({"op": "grow", "steps": 10001})"),
        "operations[0].steps: a whole number from 1 to 10000 ");
    row(operationsOf(R"({"op": "grow", "steps": "5"})"),
        "operations[0].steps: a whole number from 1 to 10000 is");
    row(operationsOf(R"({"op": "grow", "steps": 2.5})"),
        "operations[0].steps: a whole number from 1 to 10000 is expected");
    row(operationsOf(R"({"op": "grow", "steps": 5, "count": 5})"),
        "operations[0]: “count” is not known here");
    row(operationsOf(R"({"op": "lasso", "points": [[0, 1], [2, 3]]})"),
        "operations[0].points: a lasso needs at least three points");
    row(operationsOf(R"({"op": "lasso", "points": [[0, 1], [2, 3], [1]]})"),
        "operations[0].points[2]: two numbers within");
    row(operationsOf(R"({"op": "lasso", "points": [[0, 1], [2, 3], [1, 1001]]})"),
        "operations[0].points[2]: two numbers within");
    row(operationsOf(R"({"op": "lasso", "up": [1, 0, 0], "points": [[0, 1], [2, 3], [1, 1]]})"),
        "operations[0].up: right and up must have length 1");
    row(operationsOf(R"({"op": "lasso", "origin": [1, 0], "points": [[0, 1], [2, 3], [1, 1]]})"),
        "operations[0].origin: three numbers within");
    row(operationsOf(R"({"op": "prune", "internodes": []})"),
        "operations[0].internodes: 1 to 100000 internodes are expected");
    row(operationsOf(R"({"op": "prune", "internodes": [3, 1.5]})"),
        "operations[0].internodes[1]: a whole number from 0 to 4294967294 is expected");
    row(operationsOf(R"({"op": "prune", "internodes": [{"internode": 3}]})"),
        "operations[0].internodes[0]: a key (“key”) or a place (“at”) is expected");
    row(operationsOf(R"({"op": "invigorate", "internode": 3})"), "operations[0].seconds: it is missing");
    row(operationsOf(R"({"op": "invigorate", "internode": 3, "seconds": 601})"),
        "operations[0].seconds: a number from 0 to 600 is expected");
    row(operationsOf(R"({"op": "reduce", "seconds": 1})"), "operations[0].internode: it is missing");
    row(operationsOf(R"({"op": "reduce", "internode": 3, "seconds": -1})"),
        "operations[0].seconds: a number from 0 to 600 is expected");
    row(operationsOf(R"({"op": "grow", "steps": 2, "only": {"bud": 1}})"),
        "operations[0].only.internode: it is missing");
    row(operationsOf(R"({"op": "grow", "steps": 2, "only": {"internode": 1, "bud": 6}})"),
        "operations[0].only.bud: there is no such bud");
    row(operationsOf(R"({"op": "regrow", "steps": 2})"), "operations[0]: “steps” is not known here");
    row(operationsOf(R"({"op": "fillEnvelopes", "parameters": {}})"),
        "operations[0].parameters: “envelopes” must be given with them");
    row(operationsOf(R"({"op": "fillEnvelopes", "envelopes": []})"),
        "operations[0].envelopes: 1 to 10000 envelopes are expected");
    row(operationsOf(R"({"op": "fillEnvelopes", "envelopes": [{"points": [[0, 1], [1, 1]]}]})"),
        "operations[0].envelopes[0].points: a lasso needs at least three points");
    row(operationsOf(
            R"({"op": "fillEnvelopes", "envelopes": [{"points": [[0, 1], [1, 1], [1, 2]], "op": "x"}]})"),
        "operations[0].envelopes[0]: “op” is not known here");
    row(operationsOf(R"({"op": "fillEnvelopes", "steps": 10001})"),
        "operations[0].steps: a whole number from 0 to 10000 is expected");
    row(operationsOf(R"({"op": "import", "segments": []})"),
        "operations[0].segments: 1 to 1000000 segments are expected");
    row(operationsOf(R"({"op": "import", "segments": [[-1, 0, 0, 0, 0, 1, 0]]})"),
        "operations[0].segments[0]: 8 numbers are expected");
    row(operationsOf(R"({"op": "import", "segments": [[0, 0, 0, 0, 0, 1, 0, 0.1]]})"),
        "operations[0].segments[0]: its parent is neither one of the segments before it");
    row(operationsOf(R"({"op": "import", "segments": [[-1, 0, 0, 0, 0, 1, 0, 51]]})"),
        "operations[0].segments[0]: its radius is not between 0 and 50 m");
    row(operationsOf(R"({"op": "sketch"})"), "operations[0].strokes: 1 to 1000 strokes are expected");
    row(operationsOf(R"({"op": "sketch", "strokes": [[[0, 0], [0, 1]], []]})"),
        "operations[0].strokes[1]: a stroke needs at least one point");
    row(operationsOf(R"({"op": "sketch", "strokes": [[[0, 0], [0, 1001]]]})"),
        "operations[0].strokes[0][1]: two numbers within ±1000 are expected, right and up, in m");
    row(operationsOf(R"({"op": "sketch", "strokes": [[[0, 0], [0, 1]]], "trees": 3})"),
        "operations[0].trees: a whole number from 1 to 2 is expected");
    row(operationsOf(R"({"op": "sketch", "strokes": [[[0, 0], [0, 1]]], "sideways": "some"})"),
        "operations[0].sideways: one of these is expected: all, limbs, none");
    row(operationsOf(R"({"op": "sketchStroke", "points": [[0, 0]]})"),
        "operations[0].points: a stroke needs at least 2 points");
    row(operationsOf(R"({"op": "sketchStroke", "points": [[0, 0], [0, 1]], "radii": [0.1, -1]})"),
        "operations[0].radii: numbers from 0 to 100 are expected, in m");
    row(operationsOf(R"({"op": "infer", "hull": 9})"),
        "operations[0].hull: a number from 0.5 to 3 is expected");
    row(operationsOf(R"({"op": "multiply"})"), "operations[0].internode: it is missing");
    row(operationsOf(R"({"op": "multiply", "internode": 1, "count": 1001})"),
        "operations[0].count: a whole number from 1 to 1000 is expected");
    row(operationsOf(R"({"op": "propagate", "internode": 1, "targets": "some"})"),
        "operations[0].targets: one of these is expected: all, sameOrder, [internode, …]");
    row(operationsOf(R"({"op": "propagate", "internode": 1, "targets": []})"),
        "operations[0].targets: 1 to 10000 internodes are expected");
    row(operationsOf(R"({"op": "propagate", "internode": 1, "targets": [2, -1]})"),
        "operations[0].targets[1]: a whole number from 0 to 4294967294 is expected");
    row(operationsOf(R"({"op": "propagate", "internode": 1, "scaling": 1})"),
        "operations[0].scaling: true or false is expected");
    row(operationsOf(R"({"op": "propagate", "internode": 1, "replaces": "no"})"),
        "operations[0].replaces: true or false is expected");
    row(operationsOf(R"({"op": "reproduce", "silhouette": [[0, 0]]})"),
        "operations[0].trunk: a stroke needs at least one point");
    row(operationsOf(R"({"op": "reproduce", "trunk": [[0, 0], [0, 1]], "silhouette": [[0, 0], [1]]})"),
        "operations[0].silhouette[1]: two numbers within ±1000 are expected, right and up, in m");
    row(operationsOf(
            R"({"op": "reproduce", "trunk": [[0, 0], [0, 1]], "silhouette": [[0, 0]], "azimuth": 181})"),
        "operations[0].azimuth: a number from -180 to 180 is expected");
    row(operationsOf(R"({"op": "vary", "amount": 0})"),
        "operations[0].amount: a number from 0.01 to 1 is expected");
    row(operationsOf(R"({"op": "import", "file": "tree.csv"})"),
        "operations[0].file: tree.csv: a recipe that was not read from a file cannot name files");
    row(operationsOf(R"({"op": "undo", "count": -1})"),
        "operations[0].count: a whole number from 1 to 100000");
    row(operationsOf(R"({"op": "setParameters"})"), "operations[0].parameters: it is missing");
    row(operationsOf(R"({"op": "setParameters", "parameters": {"growth": {"x": 1}}})"),
        "operations[0].parameters.growth.x: there is no such parameter");
    row(recipeOf(R"("parameters": {"growht": {}})"), "parameters.growht: there is no such parameter");
    row(recipeOf(R"("parameters": {"growth": 1})"), "parameters.growth: an object is expected");
    row(recipeOf(R"("parameters": {"growth": {"shedding": "0.5"}})"),
        "parameters.growth.shedding: a number is expected");
    row(recipeOf(R"("parameters": {"growth": {"markerAge": 1.5}})"),
        "parameters.growth.markerAge: a whole number is expected");
    row(recipeOf(R"("parameters": {"growth": {"uprightTrunk": 1}})"),
        "parameters.growth.uprightTrunk: true or false is expected");
    row(recipeOf(R"("parameters": {"leaves": {"shape": "round"}})"),
        "parameters.leaves.shape: one of these is expected: ovate, lanceolate, lobed, needles");
    row(recipeOf(R"("parameters": {"leaves": {"shape": 1}})"),
        "parameters.leaves.shape: one of these is expected");
    row(recipeOf(R"("parameters": {"growth": {"axisWeight": 0, "tropismWeight": 0, "spaceWeight": 0}})"),
        "parameters.growth.axisWeight: axisWeight, tropismWeight and spaceWeight must not all be 0");
    row(recipeOf(R"("parameters": {"growth": {"ellipseOffset": -0.995}})"),
        "parameters.growth.ellipseOffset: it must not exceed 0.99 times ellipseVertical, which is 1");
    row(operationsOf(R"({"op": "setParameters", "parameters": {"growth": {"ellipseOffset": 0.9}}},
                      {"op": "setParameters", "parameters": {"growth": {"ellipseVertical": 0.9}}})"),
        "operations[1].parameters.growth.ellipseOffset: it must not exceed 0.99 times ellipseVertical, "
        "which is 0.9");

    const auto stroke = [](const QByteArray& samples) {
        return operationsOf(R"({"op": "brushStroke", "samples": [)" + samples + "]}");
    };
    row(stroke(""), "operations[0].samples: a stroke needs at least one sample");
    row(operationsOf(R"({"op": "brushStroke"})"), "operations[0].samples: a stroke needs at least one");
    row(stroke("5"), "operations[0].samples[0]: an array of five numbers");
    row(stroke("[0,0,0,0]"), "operations[0].samples[0]: an array of five numbers is");
    row(stroke("[0,0,0,0,null]"), "operations[0].samples[0]: an array of five numbers is expected");
    row(stroke("[0,0,0,0,1,1]"), "operations[0].samples[0]: an array of five numbers is expected: time");
    row(stroke("[-0.1,0,0,0,1]"), "operations[0].samples[0]: the time is not within 0…600 s");
    row(stroke("[0,0,0,0,1],[600.5,0,0,0,1]"), "operations[0].samples[1]: the time is not within 0…600 s");
    row(stroke("[0,0,0,0,1],[1,0,0,0,1],[0.5,0,0,0,1]"),
        "operations[0].samples[2]: the time does not go forwards");
    row(stroke("[0,0,0,0,1],[1,0,0,0,1],[1,0,0,0,1],[0,0,0,0,1]"),
        "operations[0].samples[2]: the time does not go");
    row(stroke("[0,1000.5,0,0,1]"), "operations[0].samples[0]: a coordinate is not within ±1000 m");
    row(stroke("[0,0,0,-1e300,1]"), "operations[0].samples[0]: a coordinate is not within ±1000");
    row(operationsOf(R"({"op": "brushStroke", "until": 601, "samples": [[0, 0, 0, 0, 1]]})"),
        "operations[0].until: a number from 0 to 600 is expected");
    row(stroke("[0,0,0,0,-0.01]"), "operations[0].samples[0]: the radius is not within 0…100 m");
    row(stroke("[0,0,0,0,100.01]"), "operations[0].samples[0]: the radius is not within 0…100");

    const auto bend = [](const QByteArray& handle, const QByteArray& rest = {}) {
        return operationsOf(R"({"op": "bend", "base": 0, "handles": [)" + handle + "]" + rest + "}");
    };
    const QByteArray held = R"({"internode": 3, "target": [0, 1, 2]})";
    row(bend(""), "operations[0].handles: a bend needs 1 to 100 handles");
    row(bend(QByteArray(held + ',').repeated(100) + held), "operations[0].handles: a bend needs 1 to 100");
    row(operationsOf(R"({"op": "bend", "handles": []})"), "operations[0].base: it is missing");
    row(bend("5"), "operations[0].handles[0]: an object is expected");
    row(bend(R"({"internode": -1, "target": [0, 1, 2]})"),
        "operations[0].handles[0].internode: a whole number from 0 to 4294967294");
    row(bend(R"({"internode": 3})"), "operations[0].handles[0].target: an array of three numbers");
    row(bend(held + R"(, {"internode": 3, "target": [0, 1]})"),
        "operations[0].handles[1].target: an array of three numbers within ±1000");
    row(bend(R"({"internode": 3, "target": [0, 1, 2, 3]})"),
        "operations[0].handles[0].target: an array of three numbers within");
    row(bend(R"({"internode": 3, "target": [0, "1", 2]})"),
        "operations[0].handles[0].target: an array of three numbers within ±");
    row(bend(R"({"internode": 3, "target": [0, 1000.5, 2]})"),
        "operations[0].handles[0].target: an array of three numbers within ±1000 is");
    row(bend(R"({"internode": 3, "along": 1.01, "target": [0, 1, 2]})"),
        "operations[0].handles[0].along: a number from 0 to 1 is expected");
    row(bend(R"({"internode": 3, "target": [0, 1, 2], "x": 1})"),
        "operations[0].handles[0]: “x” is not known");
    row(bend(held, R"(, "bending": 0)"), "operations[0].bending: a number from 0.01 to 100 is expected");
    row(bend(held, R"(, "stretching": "1")"),
        "operations[0].stretching: a number from 0.01 to 100 is expected");
    row(bend(held, R"(, "moves": [{"targets": []}])"),
        "operations[0].moves[0].targets: a target for each handle is expected");
    row(bend(held, R"(, "moves": [{"targets": [[0, 1]]}])"),
        "operations[0].moves[0].targets: arrays of three numbers within ±1000 are expected");
    row(bend(held, R"(, "moves": [{"targets": [[0, 1, 2]], "calls": 0}])"),
        "operations[0].moves[0].calls: a whole number from 1 to 100000 is expected");
    row(bend(held, R"(, "moves": [5])"), "operations[0].moves[0]: an object is expected");
    row(bend(held, R"(, "regrips": [{"base": 0, "handles": []}])"),
        "operations[0].regrips[0].handles: a bend needs 1 to 100 handles");
    row(bend(held, R"(, "regrips": [{"base": 0, "handles": [)" + held + R"(], "bending": 1}])"),
        "operations[0].regrips[0]: “bending” is not known here");
    row(operationsOf(R"({"op": "setWidth", "internode": 1, "diameter": 1, "from": {}})"),
        "operations[0].from: a key (“key”) or a place (“at”) is expected");
    row(operationsOf(R"({"op": "twist", "internode": 1})"), "operations[0].angle: it is missing");
    row(operationsOf(R"({"op": "twist", "internode": 1, "angle": 181})"),
        "operations[0].angle: a number from -180 to 180 is expected");
    row(operationsOf(R"({"op": "twist", "internode": 1, "angle": 1, "scope": "tree"})"),
        "operations[0].scope: one of these is expected: branch, subtree");
    row(operationsOf(R"({"op": "twist", "internode": 1, "angle": 1, "steps": 2})"),
        "operations[0]: “steps” is not known here");
    row(operationsOf(R"({"op": "addBuds"})"), "operations[0].internode: it is missing");
    row(operationsOf(R"({"op": "addBuds", "internode": 1, "count": 9})"),
        "operations[0].count: a whole number from 1 to 8 is expected");
    row(operationsOf(R"({"op": "addBuds", "internode": 1, "count": 2.5})"),
        "operations[0].count: a whole number from 1 to 8 is expected");
    row(operationsOf(R"({"op": "addBuds", "internode": 1, "spacing": -1})"),
        "operations[0].spacing: a number from 0 to 1 is expected");
    row(operationsOf(R"({"op": "addBuds", "internode": 1, "along": 1.5})"),
        "operations[0].along: a number from 0 to 1 is expected");
    row(operationsOf(R"({"op": "addBuds", "internode": 1, "azimuth": 400})"),
        "operations[0].azimuth: a number from -360 to 360 is expected");
    row(operationsOf(R"({"op": "brushStroke", "samples": [[0, 0, 0, 0, 1]], "copies": 13})"),
        "operations[0].copies: a whole number from 1 to 12 is expected");
    row(operationsOf(R"({"op": "brushStroke", "samples": [[0, 0, 0, 0, 1]], "around": [0, 1]})"),
        "operations[0].around: three numbers within ±1000 are expected: x, y, z, in m");
    row(operationsOf(R"({"op": "keepClear", "internode": 1})"), "operations[0].length: it is missing");
    row(operationsOf(R"({"op": "keepClear", "internode": 1, "length": -1})"),
        "operations[0].length: a number from 0 to 1000 is expected");
    row(operationsOf(R"({"op": "erase", "sweeps": []})"),
        "operations[0].sweeps: one stroke or more is expected");
    row(operationsOf(R"({"op": "erase", "sweeps": [{"eye": [0, 0], "path": [[0, 0, 0, 1]]}]})"),
        "operations[0].sweeps[0].eye: three numbers within ±1000 are expected: x, y, z, in m");
    row(operationsOf(R"({"op": "erase", "sweeps": [{"eye": [0, 0, 5], "path": []}]})"),
        "operations[0].sweeps[0].path: a stroke needs at least one point");
    row(operationsOf(R"({"op": "thin", "sweeps": [{"eye": [0, 0, 5], "path": [[0, 0, 0, -1]]}]})"),
        "operations[0].sweeps[0].path[0]: four numbers are expected: x, y, z within ±1000 m, and a radius "
        "within 0…100 m");
    row(operationsOf(R"({"op": "thin", "share": 2, "sweeps": [{"eye": [0, 0, 5], "path": [[0, 0, 0, 1]]}]})"),
        "operations[0].share: a number from 0 to 1 is expected");
    const auto leaf = [&](const QByteArray& members) {
        return operationsOf(R"({"op": "placeLeaf", "internode": 1)" + members + "}");
    };
    row(leaf(R"(, "rotation": [0, 0, 0, 1])"), "operations[0].length: it is missing");
    row(leaf(R"(, "length": 0.1)"), "operations[0].rotation: it is missing");
    for (const char* rotation : {"[0, 0, 1]", "[0, 0, 0, 0]", "[0, 0, 0, 2]", R"([0, 0, 0, "1"])", "1"}) {
        row(leaf(QByteArray(R"(, "length": 0.1, "rotation": )") + rotation),
            "operations[0].rotation: a quaternion is expected: four numbers x, y, z, w within ±1, not all of "
            "them 0");
    }
    row(leaf(R"(, "rotation": [0, 0, 0, 1], "length": 0)"),
        "operations[0].length: a number from 0.0001 to 100 is expected");
    row(leaf(R"(, "rotation": [0, 0, 0, 1], "length": 1, "along": -1)"),
        "operations[0].along: a number from 0 to 1 is expected");
    row(leaf(R"(, "rotation": [0, 0, 0, 1], "length": 1, "kind": "thorn")"),
        "operations[0].kind: one of these is expected: leaf, flower, fruit");
    row(operationsOf(R"({"op": "arrange", "internode": 1})"), "operations[0].engine: it is missing");
    row(operationsOf(R"({"op": "arrange", "internode": 1, "engine": "spiral"})"),
        "operations[0].engine: one of these is expected: addToWhorl, extendWhorls, alternate, opposite, "
        "decussate");
    row(operationsOf(R"({"op": "arrange", "engine": "alternate"})"),
        "operations[0].internode: it is missing");
    row(operationsOf(R"({"op": "arrange", "engine": "alternate", "internode": 1, "along": 2})"),
        "operations[0].along: a number from 0 to 1 is expected");
    row(operationsOf(R"({"op": "setWidth", "internode": 1})"), "operations[0].diameter: it is missing");
    row(operationsOf(R"({"op": "setWidth", "internode": 1, "diameter": -0.1})"),
        "operations[0].diameter: a number from 0 to 100 is expected");
    const QByteArray square = R"({"boundaries": [[[0, 0], [1, 0], [1, 1], [0, 1]]]})";
    const auto profile = [&](const QByteArray& members) {
        return operationsOf(R"({"op": "setProfile", "internodes": [1], )" + members + "}");
    };
    row(operationsOf(R"({"op": "setProfile", "internodes": [], "clear": true})"),
        "operations[0].internodes: 1 to 10000 internodes are expected");
    row(operationsOf(R"({"op": "setProfile", "internodes": [1, -1], "clear": true})"),
        "operations[0].internodes[1]: a whole number from 0 to 4294967294 is");
    row(operationsOf(R"({"op": "setProfile", "internodes": [1]})"), "operations[0].profile: ");
    row(profile(R"("clear": false)"), "operations[0].clear: true is expected");
    row(profile(R"("clear": true, "profile": )" + square), "operations[0]: “profile” is not known");
    row(profile(R"("profile": {"boundaries": [[[0, 0], [1, 0]]]})"),
        "operations[0].profile: an outline needs at least three points");
    row(profile(R"("profile": {"boundaries": [[[0, 0], [1, 1], [1, 0], [0, 1]]]})"),
        "operations[0].profile: its outline crosses itself");
    row(profile(R"("profile": {"boundaries": [[[0, 0], [1, 1], 5]]})"),
        "operations[0].profile.boundaries: lists of points [x, y] are expected");
    row(profile(R"("toProfile": )" + square + R"(, "profile": )" + square),
        "operations[0].toProfile: the other end of the branch (“to”) is missing");
    row(operationsOf(R"({"op": "setProfile", "internodes": [1, 2], "to": 3, "clear": true})"),
        "operations[0].to: a branch must begin at exactly one internode");
    row(operationsOf(R"({"op": "setWidth", "internode": 4294967295, "diameter": 1})"),
        "operations[0].internode: a whole number from 0 to 4294967294 is");
}

void WrongRecipesTest::wrongRecipes_nameThePlace()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, message);
    const Result<Recipe> result = parseRecipe(json);
    QVERIFY(!result);
    QCOMPARE(result.error().kind, Error::Kind::Input);
    QVERIFY2(result.error().message.startsWith(message), qPrintable(result.error().message));
}

void WrongRecipesTest::wrongParameters_areAllRefusedJustBeyondTheirLimits()
{
    int tried = 0;
    TreeParameters parameters;
    visitParameters(parameters, [&](const ParameterInfo& info, const auto&) {
        if (info.quantity == Quantity::Switch || info.quantity == Quantity::Choice)
            return;
        const QStringList key = QString::fromLatin1(info.key).split(QLatin1Char('.'));
        const double step = info.quantity == Quantity::Count ? 1.0 : 1e-9;
        const auto set = [&](double value) {
            return bool(fromJson({{key[0], QJsonObject{{key[1], value}}}}, {}, QStringLiteral("p")));
        };
        ++tried;
        QVERIFY2(!set(info.minimum - step), info.key);
        QVERIFY2(!set(info.maximum + step), info.key);
        // The limits themselves are valid, except where another parameter limits the value.
        if (QLatin1String(info.key) != QLatin1String("growth.ellipseOffset")) {
            QVERIFY2(set(info.minimum), info.key);
            QVERIFY2(set(info.maximum), info.key);
        }
    });
    QVERIFY(tried > 30);
}

void WrongRecipesTest::hugeRecipes_areRefusedBeforeTheyAreParsed()
{
    Result<Recipe> result = parseRecipe(QByteArray(recipeLimits::kBytes + 1, ' '));
    QVERIFY(!result);
    QCOMPARE(result.error().message, QStringLiteral("it is larger than 64 MB"));

    result = parseRecipe(recipeOf("\"operations\": [" + QByteArray("[],").repeated(2'000'000) + "1]"));
    QVERIFY(!result);
    QCOMPARE(result.error().message, QStringLiteral("it holds too many values"));

    QByteArray samples;
    for (int i = 0; i <= recipeLimits::kSamples; ++i)
        samples += (samples.isEmpty() ? "[" : ",[") + QByteArray::number(i * 1e-5) + ",0,0,0,1]";
    result = parseRecipe(operationsOf("{\"op\":\"brushStroke\",\"samples\":[" + samples + "]}"));
    QVERIFY(!result);
    QCOMPARE(result.error().message,
             QStringLiteral("operations[0].samples: a recipe can have at most 1000000 samples"));

    result = parseRecipe(QByteArray("[").repeated(1'000'000));
    QVERIFY(!result);
}

static const TestClass<WrongRecipesTest> wrongRecipesTest;

} // namespace espalier::test

#include "WrongRecipesTest.moc"
