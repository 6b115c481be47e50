#!/usr/bin/env python3
"""Mixes a stranger's models with every one that ships: mix.py CASE, in the folder that holds the projects of the tutorials.

Each model that ships runs some steps beside the new drag law and the new contact law, in the place of one of them where it is of
that kind; then the new models run among themselves. Every run's manifest must name just the models that were asked for.
"""
import json
import subprocess
import sys

OWN = {"drag": "org.example.gibilaro", "contact": "org.example.sliding", "fluid": "org.example.wind",
       "scaling": "org.example.grains", "effect": "org.example.rough"}

# Values of the parameters that have no default.
NEEDED = {"stiffness": "100 N/m", "restitution": "0.9", "friction": "0.3", "youngs_modulus": "1e7 Pa", "poisson_ratio": "0.25",
          "coefficient": "0.1", "n": "2", "length": "0.5", "diameter": "1", "geometry": "0.5"}
# Keys of the scene without which a model refuses it.
SCENE = {
    "heat": ["scene.gas.temperature=600 K", "scene.particles.alumina.temperature=300 K",
             "scene.particles.alumina.heat_capacity=880 J/(kg K)", "scene.particles.alumina.conductivity=20 W/(m K)"],
    "oxygen_carrier": ["scene.gas.fuel=0", "scene.patches.jet.fuel=0.3", "scene.particles.alumina.conversion=0",
                       "scene.particles.alumina.oxygen_capacity=0.084"],
}


def said(*words):
    done = subprocess.run(words, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        sys.exit(f"mix.py: {words} ends with status {done.returncode}:\n{done.stdout}")
    return done.stdout


def with_what_it_needs(model):
    """The model as a case names it, with a value for each parameter that has no default."""
    parameters = json.loads(said("similitude", "plugins", "info", model, "--json"))["plugins"][0]["parameters"]
    given = [f"{p['name']}: {NEEDED[p['name']]}" for p in parameters if p["required"]]
    return "{" + ", ".join([f"id: {model}", *given]) + "}"


def run(case, models, scene=()):
    """Some steps with these models by kind, an effect only if one is among them."""
    keys = [f"models.{kind}={with_what_it_needs(model)}" for kind, model in models.items() if kind != "effect"]
    keys.append(f"models.effects=[{with_what_it_needs(models['effect']) if 'effect' in models else ''}]")
    sets = [word for key in [*keys, *scene] for word in ("--set", key)]
    said("similitude", "run", case, "-o", "mixed", "--force", "--until", "1 ms", *sets)
    with open("mixed/manifest.json") as manifest:
        ran = {plugin["id"] for plugin in json.load(manifest)["plugins"]}
    if ran != set(models.values()):
        sys.exit(f"mix.py: {set(models.values())} were asked for, {ran} ran")


case = sys.argv[1]
listed = json.loads(said("similitude", "plugins", "list", "--json"))["plugins"]
ships = [plugin for plugin in listed if plugin["id"] not in OWN.values()]
if len(listed) - len(ships) != len(OWN) or {plugin["kind"] for plugin in ships} != set(OWN):
    sys.exit(f"mix.py: models of every kind, shipped and new, should be listed: {listed}")
beside = {"drag": OWN["drag"], "contact": OWN["contact"], "fluid": "vans", "scaling": "exact"}
for plugin in ships:
    run(case, beside | {plugin["kind"]: plugin["id"]}, SCENE.get(plugin["id"], ()))
run(case, OWN)
print(f"{len(ships)} models that ship ran beside the new laws, and the new models among themselves")
