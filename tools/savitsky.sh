#!/bin/sh
# Lift and drag of a prismatic planing hull by Savitsky's regression (D. Savitsky, "Hydrodynamic design of planing hulls",
# Marine Technology 1(1), 1964), friction by the ITTC-57 line without roughness. An empirical fit, about +-10 %; holds for
# deadrise up to 30 deg, trim 2 to 15 deg, mean wetted length up to 4 beams, 0.6 <= Cv <= 13.
#
# usage: savitsky.sh beam=1 speed=8 deadrise=20 trim=5 draft=0.2 [density=1000 viscosity=1e-6 gravity=9.81]
#        lambda=MEAN_WETTED_LENGTH_OVER_BEAM in place of draft (depth of the keel at the transom)
# SI units, angles in degrees. Prints one line of JSON.
set -eu
awk -v arguments="$*" '
function tan(a) { return sin(a) / cos(a) }
BEGIN {
    value["density"] = 1000; value["viscosity"] = 1e-6; value["gravity"] = 9.81
    count = split(arguments, word, " ")
    for (i = 1; i <= count; ++i) {
        if (word[i] !~ /^(beam|speed|deadrise|trim|draft|lambda|density|viscosity|gravity)=[0-9.eE+-]+$/) {
            printf "savitsky.sh: %s: expected name=number with the names in the head of the script\n", word[i] > "/dev/stderr"
            exit 2
        }
        split(word[i], part, "="); value[part[1]] = part[2] + 0
    }
    if (!(value["beam"] > 0 && value["speed"] > 0 && value["trim"] > 0 && (value["draft"] > 0 || value["lambda"] > 0))) {
        print "savitsky.sh: beam, speed, trim and draft (or lambda) must be given and positive" > "/dev/stderr"
        exit 2
    }
    pi = atan2(0, -1)
    B = value["beam"]; U = value["speed"]; rho = value["density"]
    trim = value["trim"] * pi / 180; deadrise = value["deadrise"] * pi / 180
    half_difference = B * tan(deadrise) / (2 * pi * tan(trim))      # (L_keel - L_chine) / 2, with wave rise
    lambda = value["lambda"]
    if (!lambda) lambda = (value["draft"] / sin(trim) - half_difference) / B
    Cv = U / sqrt(value["gravity"] * B)
    flat = value["trim"] ^ 1.1 * (0.0120 * sqrt(lambda) + 0.0055 * lambda ^ 2.5 / Cv ^ 2)
    CL = flat - 0.0065 * value["deadrise"] * flat ^ 0.6
    q = rho * U * U / 2
    lift = CL * q * B * B
    # Mean speed over the bottom, from the dynamic part of the lift.
    dynamic_flat = 0.0120 * sqrt(lambda) * value["trim"] ^ 1.1
    dynamic = dynamic_flat - 0.0065 * value["deadrise"] * dynamic_flat ^ 0.6
    bottom_speed = U * sqrt(1 - dynamic / (lambda * cos(trim)))
    Re = bottom_speed * lambda * B / value["viscosity"]
    Cf = 0.075 / (log(Re) / log(10) - 2) ^ 2
    friction = rho * bottom_speed ^ 2 / 2 * lambda * B * B * Cf / (cos(deadrise) * cos(trim))  # its part along the stream
    printf "{\"lift\": %.7g, \"pressure_drag\": %.7g, \"friction_drag\": %.7g, \"drag\": %.7g, \"Cf\": %.7g, \"lambda\": %.7g, \"Cv\": %.7g, \"keel_wetted_length\": %.7g, \"chine_wetted_length\": %.7g}\n",
        lift, lift * tan(trim), friction, lift * tan(trim) + friction, Cf, lambda, Cv, lambda * B + half_difference, lambda * B - half_difference
}'
