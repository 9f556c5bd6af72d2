"""Medians that criterion estimated, by the full id of the bench: of one element where a bench has several."""

import json


class Estimates:
    """Medians in ns, by id."""

    def __init__(self, medians):
        self.medians = dict(medians)
        for name in medians:
            # The chain that feeds a step is in the times of all latencies.
            group, form = name.rsplit("/", 1)
            if group.startswith("latency/") and form != "link":
                self.medians[name] -= medians[f"{group}/link"]

    @classmethod
    def below(cls, folder, parts):
        """The newest estimates of `parts`, each in a folder of its own."""
        medians = {}
        for part in parts:
            for file in sorted((folder / part).glob("**/new/benchmark.json")):
                bench = json.loads(file.read_text())
                estimates = json.loads((file.parent / "estimates.json").read_text())
                elements = (bench["throughput"] or {}).get("Elements", 1)
                medians[bench["full_id"]] = estimates["median"]["point_estimate"] / elements
        return cls(medians)

    def __contains__(self, name):
        return name in self.medians

    def __getitem__(self, name):
        return self.medians[name]

    def __iter__(self):
        return iter(sorted(self.medians))

    def ratio(self, one, other):
        """How many times as long `one` takes as `other`; none without both."""
        if one in self and other in self:
            return self[one] / self[other]
        return None
