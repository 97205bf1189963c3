# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sums of a storm: relations and failures by kind, as text and as JSON; and what is owed."""
import collections
import json


def owed(path):
    """Failures that are known: (seed, relation, kind) and why, of lines "SEED RELATION / KIND: REASON"."""
    found = {}
    if path is None:
        return found
    for line in path.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            what, reason = line.split(": ", 1)
            seed, rest = what.split(" ", 1)
            relation, kind = rest.split(" / ")
            found[int(seed), relation.strip(), kind.strip()] = reason.strip()
    return found


def failures(records):
    for record in records:
        for verdict in record["verdicts"]:
            if verdict["verdict"] == "fails":
                yield (record["seed"], verdict["relation"], verdict["kind"]), record, verdict


def sums(records):
    """Of every relation how often it was asked, held, met a bifurcation, and failed in which ways."""
    result = {}
    for record in records:
        for verdict in record["verdicts"]:
            row = result.setdefault(verdict["relation"], {"asked": 0, "holds": 0, "bifurcation": 0, "fails": {}})
            row["asked"] += 1
            if verdict["verdict"] == "fails":
                row["fails"][verdict["kind"]] = row["fails"].get(verdict["kind"], 0) + 1
            else:
                row[verdict["verdict"]] += 1
    return result


def text(records):
    lines = ["| relation | asked | holds | bifurcation | fails | of which |", "|---|---|---|---|---|---|"]
    for relation, row in sorted(sums(records).items(), key=lambda item: (item[0] != "run", item[0])):
        kinds = ", ".join(f"{kind} {n}" for kind, n in sorted(row["fails"].items(), key=lambda item: -item[1]))
        lines.append(f"| {relation} | {row['asked']} | {row['holds']} | {row['bifurcation']} | "
                     f"{sum(row['fails'].values())} | {kinds} |")
    lines += ["", "| model and scheme | scenes | with a failure | s of processor time a scene |", "|---|---|---|---|"]
    groups = collections.defaultdict(list)
    for record in records:
        groups[f"{record['model']} {record['scheme']}"].append(record)
    for name, group in sorted(groups.items()):
        wrong = sum(any(v["verdict"] == "fails" for v in record["verdicts"]) for record in group)
        lines.append(f"| {name} | {len(group)} | {wrong} | {sum(r['seconds'] for r in group) / len(group):.1f} |")
    return "\n".join(lines) + "\n"


def write(records, folder):
    records = sorted(records, key=lambda record: record["seed"])
    (folder / "table.md").write_text(text(records))
    short = [{**{key: record[key] for key in ("seed", "family", "model", "scheme", "seconds")},
              "asked": [v["relation"] for v in record["verdicts"]],
              "fails": [[v["relation"], v["kind"], v["seen"]] for v in record["verdicts"] if v["verdict"] == "fails"],
              "bifurcations": [v["relation"] for v in record["verdicts"] if v["verdict"] == "bifurcation"]}
             for record in records]
    (folder / "table.json").write_text(json.dumps({"sums": sums(records), "scenes": short}, indent=1) + "\n")


def report(records, known):
    """Lines about what is new and what is no longer owed, and whether something is new."""
    lines, seen = [], set()
    new = False
    for key, record, verdict in failures(records):
        seen.add(key)
        if key not in known:
            new = True
            lines.append(f"FAILS: seed {key[0]} ({record['model']}, {record['scheme']}, {record['family']}), "
                         f"{key[1]}, {key[2]}: {verdict['seen']}")
    asked = {(record["seed"], verdict["relation"]) for record in records for verdict in record["verdicts"]}
    for key, reason in known.items():
        if key not in seen and key[:2] in asked:
            lines.append(f"no longer owed, take it from the list: {key[0]} {key[1]} / {key[2]} ({reason})")
    return lines, new
