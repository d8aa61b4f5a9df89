#!/usr/bin/python3
"""Writes tests/data/pysph_rates.csv: the rates that PySPH (Debian: python3-pysph) finds for a free block of jittered water.

Its own kernel, neighbours, gradient correction, renormalised density gradient and artificial viscosity (delta-SPH of
Marrone et al. 2011). The diffusion sum is that of its ContinuityEquationDeltaSPH without the 0.01 h^2 that it adds to r^2
there; the pressure sum is that of bench_pysph.py.

usage: /usr/bin/python3 benchmarks/pysph_rates.py > tests/data/pysph_rates.csv
"""
import numpy as np
from pysph.base.kernels import WendlandQuintic
from pysph.base.utils import get_particle_array
from pysph.sph.equation import Equation, Group
from pysph.sph.wc.basic import ContinuityEquationDeltaSPHPreStep, MomentumEquationDeltaSPH
from pysph.sph.wc.kernel_correction import GradientCorrection, GradientCorrectionPreStep
from pysph.tools.sph_evaluator import SPHEvaluator

from bench_pysph import Pressure

DP, H, C0, RHO0, ALPHA, DELTA = 0.01, 0.015, 20.0, 1000.0, 0.02, 0.1


class Diffusion(Equation):
    def __init__(self, dest, sources, factor):
        self.factor = factor
        super().__init__(dest, sources)

    def initialize(self, d_idx, d_arho):
        d_arho[d_idx] = 0.0

    def loop(self, d_idx, s_idx, s_m, d_rho, s_rho, d_arho, d_gradrho, s_gradrho, XIJ, DWIJ, R2IJ):
        if R2IJ > 1e-12:
            twice = -2.0 * (s_rho[s_idx] - d_rho[d_idx]) / R2IJ
            x = twice * XIJ[0] - d_gradrho[3 * d_idx] - s_gradrho[3 * s_idx]
            y = twice * XIJ[1] - d_gradrho[3 * d_idx + 1] - s_gradrho[3 * s_idx + 1]
            z = twice * XIJ[2] - d_gradrho[3 * d_idx + 2] - s_gradrho[3 * s_idx + 2]
            d_arho[d_idx] += self.factor * (x * DWIJ[0] + y * DWIJ[1] + z * DWIJ[2]) * s_m[s_idx] / s_rho[s_idx]


random = np.random.default_rng(7)
x, y, z = (a.ravel() for a in np.meshgrid(*((np.arange(n) + 0.5) * DP for n in (8, 7, 6)), indexing="ij"))
x, y, z = (np.round(a + random.uniform(-0.2, 0.2, x.size) * DP, 6) for a in (x, y, z))
u, v, w = (np.round(random.uniform(-1, 1, x.size), 3) for _ in range(3))
drho = np.round(random.uniform(0, 5, x.size), 3)
fluid = get_particle_array(name="fluid", x=x, y=y, z=z, u=u, v=v, w=w, m=RHO0 * DP**3, rho=RHO0 + drho, h=H,
                           p=C0**2 * drho, cs=C0)
fluid.add_property("gradrho", stride=3)
fluid.add_property("m_mat", stride=9)
for name in ("arho", "au", "av", "aw"):
    fluid.add_property(name)
names = ["fluid"]
SPHEvaluator([fluid], [
    Group([GradientCorrectionPreStep("fluid", names, dim=3)]),
    Group([GradientCorrection("fluid", names, dim=3, tol=1e9), ContinuityEquationDeltaSPHPreStep("fluid", names)]),
    Group([Diffusion("fluid", names, DELTA * H * C0), MomentumEquationDeltaSPH("fluid", names, RHO0, C0, ALPHA),
           Pressure("fluid", names)]),
], dim=3, kernel=WendlandQuintic(dim=3)).evaluate()

print("x,y,z,u,v,w,drho,ax,ay,az,diffusion")
for i in range(x.size):
    print(f"{x[i]:.6f},{y[i]:.6f},{z[i]:.6f},{u[i]:.3f},{v[i]:.3f},{w[i]:.3f},{drho[i]:.3f},"
          f"{fluid.au[i]:.6e},{fluid.av[i]:.6e},{fluid.aw[i]:.6e},{fluid.arho[i]:.6e}")
