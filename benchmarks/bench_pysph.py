#!/usr/bin/python3
"""The right-hand side that bench_sph times, made by PySPH (Debian: python3-pysph), as rows of a table.

A periodic block of jittered particles, Wendland C2 kernel: neighbours, renormalised density gradient, then delta-SPH's
continuity and momentum equations (Marrone et al. 2011), by PySPH's own classes but for the pressure term, which
its MomentumEquationDeltaSPH leaves out; no time integration. PySPH generates and
compiles C++ for it on first use (a minute), in double precision, with OpenMP.

usage: OMP_NUM_THREADS=2 /usr/bin/python3 benchmarks/bench_pysph.py [particles along an edge] [seconds per row]
"""
import os
import sys
import time

import numpy as np
from compyle.config import get_config
from pysph.base.kernels import WendlandQuintic
from pysph.base.nnps import DomainManager
from pysph.base.utils import get_particle_array
from pysph.sph.basic_equations import ContinuityEquation
from pysph.sph.equation import Equation, Group
from pysph.sph.wc.basic import (ContinuityEquationDeltaSPH, ContinuityEquationDeltaSPHPreStep, MomentumEquationDeltaSPH)
from pysph.sph.wc.kernel_correction import GradientCorrection, GradientCorrectionPreStep
from pysph.tools.sph_evaluator import SPHEvaluator

DP, C0, RHO0 = 0.01, 20.0, 1000.0


class Pressure(Equation):
    """Half of MomentumEquationDeltaSPH's documentation; its code has the viscous half only."""

    def loop(self, d_idx, s_idx, s_m, d_rho, s_rho, d_p, s_p, d_au, d_av, d_aw, DWIJ):
        f = -(d_p[d_idx] + s_p[s_idx]) * s_m[s_idx] / (s_rho[s_idx] * d_rho[d_idx])
        d_au[d_idx] += f * DWIJ[0]
        d_av[d_idx] += f * DWIJ[1]
        d_aw[d_idx] += f * DWIJ[2]


def block(n, h_over_dp):
    random = np.random.default_rng(1)
    at = (np.arange(n) + 0.5) * DP
    x, y, z = (a.ravel() + random.uniform(-0.1, 0.1, n**3) * DP for a in np.meshgrid(at, at, at, indexing="ij"))
    rho = RHO0 * (1 + 1e-3 * np.sin(2 * np.pi * x / (n * DP)))
    fluid = get_particle_array(name="fluid", x=x, y=y, z=z, m=RHO0 * DP**3, rho=rho, h=h_over_dp * DP,
                               p=C0**2 * (rho - RHO0), cs=C0)
    for name, stride in (("gradrho", 3), ("m_mat", 9)):
        fluid.add_property(name, stride=stride)
    for name in ("arho", "au", "av", "aw"):
        fluid.add_property(name)
    return fluid


def rate(n, h_over_dp, seconds):
    fluid = block(n, h_over_dp)
    names = ["fluid"]
    equations = [
        Group([GradientCorrectionPreStep("fluid", names, dim=3)], real=False),
        Group([GradientCorrection("fluid", names, dim=3, tol=0.5), ContinuityEquationDeltaSPHPreStep("fluid", names)],
              real=False, update_nnps=False),
        Group([ContinuityEquation("fluid", names), ContinuityEquationDeltaSPH("fluid", names, c0=C0, delta=0.1),
               Pressure("fluid", names), MomentumEquationDeltaSPH("fluid", names, rho0=RHO0, c0=C0, alpha=0.02)]),
    ]
    edge = n * DP
    domain = DomainManager(xmin=0, xmax=edge, ymin=0, ymax=edge, zmin=0, zmax=edge, periodic_in_x=True,
                           periodic_in_y=True, periodic_in_z=True)
    evaluator = SPHEvaluator([fluid], equations, dim=3, kernel=WendlandQuintic(dim=3), domain_manager=domain)
    evaluator.evaluate()
    start, steps, lists = time.perf_counter(), 0, 0.0
    while time.perf_counter() - start < seconds or steps < 3:
        before = time.perf_counter()
        evaluator.update()
        lists += time.perf_counter() - before
        evaluator.evaluate()
        steps += 1
    wall = time.perf_counter() - start
    evaluations = n**3 * steps / wall
    neighbours = 4 / 3 * np.pi * (2 * h_over_dp) ** 3
    return evaluations, evaluations * neighbours, lists / wall


if __name__ == "__main__":
    get_config().use_openmp = True
    edge = int(sys.argv[1]) if len(sys.argv) > 1 else 46
    duration = float(sys.argv[2]) if len(sys.argv) > 2 else 10
    threads = os.environ.get("OMP_NUM_THREADS", str(os.cpu_count()))
    print("| code | particles | h/dp | threads | M evaluations/s | M pairs/s | in neighbour search |\n|---|---|---|---|---|---|---|")
    for ratio in (1.5, 2.0):
        evaluations, pairs, search = rate(edge, ratio, duration)
        print(f"| PySPH | {edge**3} | {ratio} | {threads} | {evaluations / 1e6:.3f} | {pairs / 1e6:.1f} | {100 * search:.0f} % |",
              flush=True)
