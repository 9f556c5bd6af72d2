"""SciPy: solve_ivp, the older compiled solvers behind `ode`, and the exact map by expm with a loop in Python."""

from rows import DAMPING, MASS, PERIOD, STIFFNESS, rate, rollout, row, serve

TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12)


def load():
    import scipy
    from scipy.integrate import ode, solve_ivp
    from scipy.linalg import expm

    def exact():
        generator = [[0.0, 1.0, 0.0], [-STIFFNESS / MASS, -DAMPING / MASS, -1.0 / MASS], [0.0, 0.0, 0.0]]
        (a, b, c), (d, e, f), _ = expm([[entry * PERIOD for entry in line] for line in generator]).tolist()
        return rollout(lambda x, v, force: (a * x + b * v + c * force, d * x + e * v + f * force))

    def ivp(method, tolerance):
        def advance(position, velocity, force):
            end = solve_ivp(
                lambda _, state: rate(*state, force),
                (0.0, PERIOD),
                (position, velocity),
                method=method,
                first_step=PERIOD,
                rtol=max(tolerance, 1e-13),
                atol=tolerance,
            )
            return end.y[0, -1], end.y[1, -1]

        return lambda: rollout(advance)

    def compiled(method, tolerance):
        def run():
            solver = ode(lambda _, state, force: rate(*state, force))
            solver.set_integrator(method, rtol=tolerance, atol=tolerance, first_step=PERIOD, nsteps=100_000)

            def advance(position, velocity, force):
                solver.set_initial_value((position, velocity), 0.0).set_f_params(force)
                return solver.integrate(PERIOD).tolist()

            return rollout(advance)

        return run

    rows = [row("SciPy expm", exact)]
    for name, solver, methods in (
        ("ode", compiled, ("dop853", "dopri5", "lsoda")),
        ("solve_ivp", ivp, ("DOP853", "RK45", "LSODA")),
    ):
        for method in methods:
            for tolerance in TOLERANCES:
                rows.append(row(f"SciPy {name} {method}", solver(method, tolerance), tolerance=tolerance))
    return scipy.__version__, rows


serve("scipy", load)
